// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LookSwitch_h
#define Explore_LookSwitch_h

#include "Applications/Explorer/Live/KeyBinding.h"
#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace Explore
{
/// Switches between the outside of a volume and its dense inside by key O. Hidden tissue is not
/// felt: the hand goes through the skin to the visible part. Each look has its own edited
/// functions.
class LookSwitch
{
public:
  LookSwitch(TouchScene& touch, const Analysis& analysis, vtkRenderWindowInteractor* interactor);
  /// Shows the outside, so that the inside look does not count as an edit.
  ~LookSwitch();
  LookSwitch(const LookSwitch&) = delete;
  LookSwitch& operator=(const LookSwitch&) = delete;

  /// Returns the lines for vtkHapticHeadUpDisplay::HelpText; empty if the volume has no inside.
  std::string ListKeys() const;
  /// Shows the outside. Call this before functions are loaded, because they belong to the outside.
  void ShowOutside();

private:
  void Swap();
  void Switch();

  TouchScene& Touch;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkVolumeProperty> Other; ///< functions of the look that is not shown
  const bool HasOther;
  bool IsInside = false;
  KeyBinding Key;
};
} // namespace Explore

#endif
