// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts points to screen pixels, and chooses font sizes.
 */
#ifndef HapticPixels_h
#define HapticPixels_h

#include "vtkViewport.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

/**
 * VTK's default for the dots per inch of a window. An inch has 72 points, so a point is then a
 * pixel.
 */
constexpr int OwnDotsPerInch = 72;

/**
 * Returns the number of pixels per point of a font, the factor for all lengths of a layout: 1 at
 * OwnDotsPerInch.
 */
inline double PixelsPerPoint(vtkViewport* viewport)
{
  vtkWindow* const window = viewport ? viewport->GetVTKWindow() : nullptr;
  return window ? static_cast<double>(window->GetDPI()) / OwnDotsPerInch : 1.0;
}

inline int ScalePixels(double scale, int pixels)
{
  return static_cast<int>(std::lround(scale * pixels));
}

/**
 * Returns the font size (points) in a layout that grows with its space: one point per `fraction`
 * pixels, from `least` to `most`. On a screen with more than one pixel per point, the size may be
 * less than `least`, down to 6, if the space is less than nine such letters.
 */
inline int FitLetters(int pixels, int fraction, double scale, int least, int most)
{
  const auto room = static_cast<int>(pixels / (9.0 * scale));
  const int smallest = scale > 1.0 ? std::clamp(room, std::min(6, least), least) : least;
  return std::clamp(static_cast<int>(pixels / (fraction * scale)), std::min(smallest, most), most);
}

} // namespace VolumeHaptics

#endif
