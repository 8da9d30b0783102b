// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts lengths in points to pixels of the screen, and chooses the size of letters.
 */
#ifndef HapticPixels_h
#define HapticPixels_h

#include "vtkViewport.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

/** VTK's default dots per inch of a vtkWindow: an inch has 72 points, so a point is a pixel. */
constexpr int OwnDotsPerInch = 72;

/**
 * Returns the pixels per point of letters. Layouts multiply their lengths by it: it is 1 at
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
 * Returns the size of letters (points) in a layout that grows with its room: one point for each
 * `fraction` pixels. If a point takes more than one pixel, the size may be less than `least`, down
 * to 6, but only in a room of less than nine such letters.
 */
inline int FitLetters(int pixels, int fraction, double scale, int least, int most)
{
  const auto room = static_cast<int>(pixels / (9.0 * scale));
  const int smallest = scale > 1.0 ? std::clamp(room, std::min(6, least), least) : least;
  return std::clamp(static_cast<int>(pixels / (fraction * scale)), std::min(smallest, most), most);
}

} // namespace VolumeHaptics

#endif
