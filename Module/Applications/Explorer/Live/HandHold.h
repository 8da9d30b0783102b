// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandHold_h
#define Explore_HandHold_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace Explore
{
/// Commands that hold the mouse's hand in place, so that the pointer can move to a button, a menu
/// or another window while the hand still presses. Key f holds or releases the hand at once. After
/// a click on the bar's button, a click in the scene holds the hand, and the next one releases it.
class HandHold
{
public:
  explicit HandHold(TouchScene& touch);
  ~HandHold();
  HandHold(const HandHold&) = delete;
  HandHold& operator=(const HandHold&) = delete;

private:
  /// Holds the hand until this number of clicks (vtkInteractorStyleHaptic::SetHoldClicks), or
  /// releases it.
  void Toggle(int clicks);
  void Report();

  TouchScene& Touch;
  int Reported = 0; // number of clicks in the last notice
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif
