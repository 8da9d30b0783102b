// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes room for a column at the right edge of a window.
 */
#ifndef SliceLayout_h
#define SliceLayout_h

#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <vector>

class vtkRenderWindow;

namespace VolumeHaptics
{

class SliceLayout
{
public:
  SliceLayout() = default;
  ~SliceLayout() { this->GiveBack(); }
  SliceLayout(const SliceLayout&) = delete;
  SliceLayout& operator=(const SliceLayout&) = delete;

  /**
   * Puts renderers into a column, the first one at its top, and narrows all others of the window
   * to what is left. The column has a share of the window's width.
   */
  void Place(vtkRenderWindow* window, const std::array<vtkRenderer*, 3>& column, double share);

  /** Gives the others their viewports back, but those that have got another one meanwhile. */
  void GiveBack();

private:
  struct Narrowed
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    std::array<double, 4> Before;
    std::array<double, 4> Now;
  };
  std::vector<Narrowed> All;
};

} // namespace VolumeHaptics

#endif
