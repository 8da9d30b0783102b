// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The overlays of other classes and programs on a part of a viewport, and the room that they leave.
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
 * Collects the boxes of the 2D actors of a renderer, such as texts, scalar bars, buttons, and the
 * sliders of VTK and FURY, also of actors that are parts of its other props, and the boxes of its
 * charts. Leaves out actors wider and higher than half of the viewport, and labels of points, which
 * are all over it.
 */
std::vector<ViewportBox> CollectActorBoxes(vtkRenderer* renderer);

/**
 * Collects the boxes of such 2D actors in all renderers of the same window, and the boxes of
 * smaller renderers in layers above 0 that show something, such as the orientation axes of VTK and
 * ParaView.
 */
std::vector<ViewportBox> CollectOverlays(vtkViewport* viewport);

/**
 * Moves a box off the overlays: to their right (across is 1) or left (-1). If the room up to a
 * margin before the edge is too small, moves the box above (up is 1) or below (-1) the overlays. If
 * there is no room at all, leaves the box where it is.
 */
ViewportBox MoveOff(
  vtkViewport* viewport, const ViewportBox& wanted, int across, int up, double margin = 0.0);

/**
 * Returns the lower left corner (pixels) for a box of this size: the viewport's own corner; if
 * overlays are there, the place to the right of them; if there is no room between them and the
 * scale of forces, the place above them; and if there is no room at all, the viewport's own corner.
 */
std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height);

/** Whether two boxes have a pixel in common. */
bool Overlaps(const ViewportBox& a, const ViewportBox& b);

/** Returns the right end (pixels) of the room for a text that begins at the upper left corner. */
double ComputeTextRight(vtkViewport* viewport);

} // namespace VolumeHaptics

#endif
