// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the overlays that other classes and programs draw over a viewport, and the free room beside
 * them. Detects parts of a host program, such as widgets, that use the mouse.
 */
#ifndef HapticOverlays_h
#define HapticOverlays_h

#include <array>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;
class vtkViewport;

namespace VolumeHaptics
{

/** A box in pixels of a viewport: left, right, bottom, top. */
using ViewportBox = std::array<double, 4>;

/**
 * Collects the boxes of a renderer's charts and 2D actors, such as texts, scalar bars, buttons, and
 * the sliders of VTK and FURY; also of 2D actors within its other props. Skips actors that exceed
 * half of the viewport in both width and height, and labels of points, which lie all over the
 * viewport.
 */
std::vector<ViewportBox> CollectActorBoxes(vtkRenderer* renderer);

/**
 * Collects the boxes of charts and 2D actors in all renderers of the viewport's window, and the
 * boxes of smaller renderers in layers above 0 that show something, such as the orientation axes of
 * VTK and ParaView.
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
 * Returns the lower left corner (pixels) for a box of this size. It is the viewport's own corner,
 * or if overlays are there, the point to the right of them. If there is no room between them and
 * the scale of forces, it is the point above them; if there is none above either, the viewport's
 * own corner.
 */
std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height);

/** Returns whether two boxes have a pixel in common. */
bool Overlaps(const ViewportBox& a, const ViewportBox& b);

/** Returns the right end (pixels) of the room for a text that begins at the upper left corner. */
double ComputeTextRight(vtkViewport* viewport);

/**
 * Returns whether a 2D actor, or the representation of one of VTK's widgets, is at a position in a
 * window (pixels). Representations are checked by the actors that they list.
 */
bool IsOverPartOfHost(vtkRenderWindow* window, int x, int y);

} // namespace VolumeHaptics

#endif
