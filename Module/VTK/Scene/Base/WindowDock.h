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

/** Same values as vtkHapticFunctionEditor::DockEdgeType. */
enum class DockEdge
{
  Left,
  Right,
  Bottom,
  Top
};

/** Returns whether a strip at an edge is as high as the window. */
constexpr bool IsColumn(DockEdge edge)
{
  return edge == DockEdge::Left || edge == DockEdge::Right;
}
/** Returns whether an edge is the left or the bottom one, which have the lower coordinate. */
constexpr bool IsLow(DockEdge edge)
{
  return edge == DockEdge::Left || edge == DockEdge::Bottom;
}

/**
 * Places a strip along an edge of a window. The first strip gets the whole edge, each later strip
 * gets an edge of the remaining window, and all other renderers of the window share the part that
 * then remains.
 */
class VTKVOLUMEHAPTICS_EXPORT WindowDock
{
public:
  WindowDock() = default;
  ~WindowDock() { this->GiveBack(); }
  WindowDock(const WindowDock&) = delete;
  WindowDock& operator=(const WindowDock&) = delete;

  /**
   * Puts renderers into the strip: at the left and right edges one below the other, the first at
   * the top; at the other edges side by side. `fraction` is the strip's fraction of the window's
   * width or height. Call it before each frame, since other renderers may come and go.
   */
  void Place(vtkRenderWindow* window, DockEdge edge, double fraction,
    const std::vector<vtkRenderer*>& strip);

  /**
   * Puts a bar along the top of the window, above all strips. `over`, which draws the bar and its
   * menus, gets the whole window. Call it before each frame.
   */
  void PlaceBar(vtkRenderWindow* window, double fraction, vtkRenderer* over);

  /** Restores the other renderers' viewports, unless they have been changed since. */
  void GiveBack();

private:
  void Enter(vtkRenderWindow* window);

  std::shared_ptr<DockLayout> Layout; ///< shared by the window's docks
};

} // namespace VolumeHaptics

#endif
