// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Icons_h
#define Explore_Icons_h

#include "vtkImageData.h"

#include <array>

namespace Explore
{
/// The icons of the bar's buttons, in the order of the buttons.
enum class Icon
{
  Menu,
  Open,
  Touch,
  Hold,
  Method,
  Preset,
  Tool,
  Cut,
  Slices,
  Measure,
  Record,
  Play,
  Look,
  None
};

using RGB = std::array<double, 3>; // 0 to 1

/// Draws an icon over an RGB image of unsigned char, in a square of `size` pixels with the lower
/// left corner at (x, y). The lines are antialiased at every size.
void DrawIcon(vtkImageData* image, Icon icon, int x, int y, int size, const RGB& colour);
} // namespace Explore

#endif
