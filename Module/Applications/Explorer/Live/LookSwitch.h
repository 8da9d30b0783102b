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
/// Key O switches between the outside of a volume and its dense inside alone. Hidden tissue is not
/// felt: the hand goes through the skin to the visible part. Each look keeps its edited functions.
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
  /// Shows the outside. Call this before functions are loaded, which belong to the outside.
  void ShowOutside();

private:
  void Swap();
  void Switch();

  TouchScene& Touch;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkVolumeProperty> Other; ///< the functions that are not shown
  const bool HasOther;
  bool IsInside = false;
  KeyBinding Key;
};
} // namespace Explore

#endif
