// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The viewports of a window with docks.
 */
#ifndef DockLayout_h
#define DockLayout_h

#include "VTK/Scene/Base/WindowDock.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

class DockLayout
{
public:
  /** The layout of a window, which all of its docks share. */
  static std::shared_ptr<DockLayout> Of(vtkRenderWindow* window);

  explicit DockLayout(vtkRenderWindow* window)
    : Window(window)
  {
  }

  vtkRenderWindow* GetWindow() const { return this->Window; }
  /** Docks are told apart by their addresses. */
  void Place(
    const WindowDock* dock, DockEdge edge, double share, const std::vector<vtkRenderer*>& strip);
  void Remove(const WindowDock* dock);

private:
  using Viewport = std::array<double, 4>; ///< left, bottom, right, top

  struct Strip
  {
    const WindowDock* Dock;
    DockEdge Edge;
    double Share;
    std::vector<vtkWeakPointer<vtkRenderer>> Renderers;
  };
  struct Narrowed
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    Viewport Before;
    Viewport Now;
  };

  static Viewport ViewportOf(vtkRenderer* renderer);
  /** Takes a strip away from the remaining part of the window. */
  static Viewport Take(const Strip& strip, Viewport& left);
  bool IsInStrip(vtkRenderer* renderer) const;
  void Arrange();
  void Narrow(vtkRenderer* renderer, const Viewport& left);

  vtkWeakPointer<vtkRenderWindow> Window;
  std::vector<Strip> Strips; ///< in order of placement
  std::vector<Narrowed> Others;
};

} // namespace VolumeHaptics

#endif
