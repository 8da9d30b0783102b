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
/// Switches between the outside of a volume and its dense inside with key o. Tissue that the inside
/// look hides can't be felt: the hand passes through the skin to the visible part. Each look has
/// its own edited functions.
class LookSwitch
{
public:
  LookSwitch(TouchScene& touch, const Analysis& analysis);
  /// Shows the outside, so that the inside look does not count as an edit.
  ~LookSwitch();
  LookSwitch(const LookSwitch&) = delete;
  LookSwitch& operator=(const LookSwitch&) = delete;

  /// Shows the outside. Call this before functions are loaded, because the loaded functions are
  /// those of the outside.
  void ShowOutside();
  /// Returns the factor by which the opacities of the shown look were multiplied.
  double GetOpacityFactor() const { return this->Factor; }

private:
  void Swap();
  void Switch();
  /// Multiplies the opacities of the shown look. Stops at a look that is barely visible.
  void ScaleOpacity(double factor);

  TouchScene& Touch;
  vtkNew<vtkVolumeProperty> Other; ///< functions of the look that is not shown
  const bool HasOther;
  bool IsInside = false;
  double Factor = 1.0;
  double OtherFactor = 1.0; // opacity factor of the look that is not shown
};
} // namespace Explore

#endif
