// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandHold_h
#define Explore_HandHold_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace Explore
{
/// Commands that hold the hand of the mouse where it is, so that the pointer can go to a button, a
/// menu or another window while the hand still presses. Key f holds and frees the hand at once;
/// after a click on the bar's button, a click in the scene holds it, and the next one frees it.
class HandHold
{
public:
  explicit HandHold(TouchScene& touch);
  ~HandHold();
  HandHold(const HandHold&) = delete;
  HandHold& operator=(const HandHold&) = delete;

private:
  /// Holds the hand until this number of clicks (vtkInteractorStyleHaptic::SetHoldClicks), or frees
  /// it.
  void Toggle(int clicks);
  void Report();

  TouchScene& Touch;
  int Reported = 0; // clicks of the last notice
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif
