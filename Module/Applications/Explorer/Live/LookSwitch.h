// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LookSwitch_h
#define Explore_LookSwitch_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace Explore
{
/// Switches between the outside of a volume and its dense inside by key o. Hidden tissue is not
/// felt: the hand goes through the skin to the visible part. Each look has its own edited
/// functions.
class LookSwitch
{
public:
  LookSwitch(TouchScene& touch, const Analysis& analysis);
  /// Shows the outside, so that the inside look does not count as an edit.
  ~LookSwitch();
  LookSwitch(const LookSwitch&) = delete;
  LookSwitch& operator=(const LookSwitch&) = delete;

  /// Shows the outside. Call this before functions are loaded, because they belong to the outside.
  void ShowOutside();
  /// Returns the factor by which the opacities of the shown look were multiplied.
  double GetOpacityFactor() const { return this->Factor; }

private:
  void Swap();
  void Switch();
  /// Multiplies the opacities of the shown look, down to a look that is hardly visible.
  void ScaleOpacity(double factor);

  TouchScene& Touch;
  vtkNew<vtkVolumeProperty> Other; ///< functions of the look that is not shown
  const bool HasOther;
  bool IsInside = false;
  double Factor = 1.0;
  double OtherFactor = 1.0; // factor of the look that is hidden
};
} // namespace Explore

#endif
