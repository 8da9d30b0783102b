// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the overlays that other classes and programs draw over a viewport, and the free space
 * beside them. Detects parts of a host program, such as widgets, that use the mouse.
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
 * Collects the boxes of a renderer's charts and 2D actors, such as texts, scalar bars, buttons, the
 * sliders of VTK and FURY, and 2D actors inside its other props. Skips actors that are larger than
 * half of the viewport in both width and height, and labels of points, which are spread over the
 * viewport.
 */
std::vector<ViewportBox> CollectActorBoxes(vtkRenderer* renderer);

/**
 * Collects the boxes of charts and 2D actors in all renderers of the viewport's window, and of
 * smaller renderers in layers above 0 that show anything, such as the orientation axes of VTK and
 * ParaView.
 */
std::vector<ViewportBox> CollectOverlays(vtkViewport* viewport);

/**
 * Moves a box off the overlays: to their right (`across` is 1) or left (-1). If there is too little
 * space up to a margin at the edge, moves the box above (`up` is 1) or below (-1) the overlays. If
 * there is no space there either, leaves the box where it is.
 */
ViewportBox MoveOff(
  vtkViewport* viewport, const ViewportBox& wanted, int across, int up, double margin = 0.0);

/**
 * Returns the lower left corner (pixels) for a box of this size: the viewport's own corner if it is
 * free, otherwise a point to the right of the overlays. If there is no space between them and the
 * scale of forces, returns a point above the overlays, and if there is no space there either, the
 * viewport's own corner.
 */
std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height);

/** Returns whether two boxes have any pixel in common. */
bool Overlaps(const ViewportBox& a, const ViewportBox& b);

/** Returns the right end (pixels) of the space for a text that starts at the upper left corner. */
double ComputeTextRight(vtkViewport* viewport);

/**
 * Returns whether a position in a window (pixels) is over a 2D actor or the representation of a VTK
 * widget. Representations are checked by the actors that they list.
 */
bool IsOverPartOfHost(vtkRenderWindow* window, int x, int y);

} // namespace VolumeHaptics

#endif
