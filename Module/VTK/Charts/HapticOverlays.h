// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What other renderers draw in a part of a viewport, and the room that they leave.
 */
#ifndef HapticOverlays_h
#define HapticOverlays_h

#include <array>
#include <vector>

class vtkViewport;

namespace VolumeHaptics
{

/** A box in pixels of a viewport: left, right, bottom, top. */
using ViewportBox = std::array<double, 4>;

/**
 * The boxes of smaller renderers of the same window, in layers above 0, that show something, such
 * as the orientation axes of VTK and ParaView.
 */
std::vector<ViewportBox> FindOverlays(vtkViewport* viewport);

/**
 * The lower left corner (pixels) for a box of this size that begins at the viewport's own corner,
 * or to the right of what is there, or above that if there is no room between it and the scale of
 * forces; the viewport's own corner if there is none above it, either.
 */
std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height);

/** How far a text may reach to the right (pixels) that begins at the upper left corner. */
double FindTextRight(vtkViewport* viewport);

} // namespace VolumeHaptics

#endif
