// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What others draw over a part of a viewport, and the room that they leave.
 */
#ifndef HapticOverlays_h
#define HapticOverlays_h

#include <array>
#include <vector>

class vtkRenderer;
class vtkViewport;

namespace VolumeHaptics
{

/** A box in pixels of a viewport: left, right, bottom, top. */
using ViewportBox = std::array<double, 4>;

/**
 * The boxes of the 2D actors of a renderer, such as texts, scalar bars, and the sliders of VTK and
 * FURY, also those that are parts of its other props. Left out are those that are wider and
 * higher than half of the viewport, and kinds whose place VTK does not tell: vtkCornerAnnotation,
 * and labels of points.
 */
std::vector<ViewportBox> FindActorBoxes(vtkRenderer* renderer);

/**
 * Those boxes of all renderers of the same window, and the boxes of smaller renderers, in layers
 * above 0, that show something, such as the orientation axes of VTK and ParaView.
 */
std::vector<ViewportBox> FindOverlays(vtkViewport* viewport);

/**
 * Where a box that is wanted somewhere stays off the overlays: to the right (across is 1) or left
 * (-1) of what is there, or if there is no room, which ends a margin before the edge, above (up is
 * 1) or below (-1) it. If there is no room at all, where it is wanted.
 */
ViewportBox MoveOff(
  vtkViewport* viewport, const ViewportBox& wanted, int across, int up, double margin = 0.0);

/**
 * The lower left corner (pixels) for a box of this size that begins at the viewport's own corner,
 * or to the right of what is there, or above that if there is no room between it and the scale of
 * forces; the viewport's own corner if there is none above it, either.
 */
std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height);

/** Whether two boxes have a pixel in common. */
bool Overlaps(const ViewportBox& a, const ViewportBox& b);

/** How far a text may reach to the right (pixels) that begins at the upper left corner. */
double FindTextRight(vtkViewport* viewport);

} // namespace VolumeHaptics

#endif
