// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reserves strips at the edges of a window for renderers beside the scene.
 */
#ifndef WindowDock_h
#define WindowDock_h

#include "vtkVolumeHapticsModule.h"

#include <memory>
#include <vector>

class vtkRenderer;
class vtkRenderWindow;

namespace VolumeHaptics
{

class DockLayout;

/** Edges of a window, with the values of vtkHapticFunctionEditor::DockEdgeType. */
enum class DockEdge
{
  Left,
  Right,
  Bottom,
  Top
};

/** Returns whether the strip at an edge is vertical, over the full height of the window. */
constexpr bool IsColumn(DockEdge edge)
{
  return edge == DockEdge::Left || edge == DockEdge::Right;
}
/** Returns whether an edge is the left or the bottom one, with the lower coordinate. */
constexpr bool IsLow(DockEdge edge)
{
  return edge == DockEdge::Left || edge == DockEdge::Bottom;
}

/**
 * Places a strip along an edge of a window. The first strip gets the whole edge, and each later
 * strip an edge of the remaining window. All other renderers of the window share what finally
 * remains.
 */
class VTKVOLUMEHAPTICS_EXPORT WindowDock
{
public:
  WindowDock() = default;
  ~WindowDock() { this->GiveBack(); }
  WindowDock(const WindowDock&) = delete;
  WindowDock& operator=(const WindowDock&) = delete;

  /**
   * Puts renderers into the strip: one below the other, from the top, at the left and right edges;
   * side by side at the other edges. `fraction` is the strip's fraction of the window's width or
   * height. Call this before each frame, since other renderers may come and go.
   */
  void Place(vtkRenderWindow* window, DockEdge edge, double fraction,
    const std::vector<vtkRenderer*>& strip);

  /**
   * Puts a bar along the top of the window, above all strips. `over`, which draws the bar and its
   * menus, gets the whole window. Call this before each frame.
   */
  void PlaceBar(vtkRenderWindow* window, double fraction, vtkRenderer* over);

  /** Restores the other renderers' viewports, unless they have been changed since. */
  void GiveBack();

private:
  void Enter(vtkRenderWindow* window);

  std::shared_ptr<DockLayout> Layout; ///< shared by all docks of the window
};

} // namespace VolumeHaptics

#endif
