// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects whether a window is rendering, and whether the frame will be shown.
 */
#ifndef HapticDrawing_h
#define HapticDrawing_h

#include "vtkRenderWindow.h"
#include "vtkViewport.h"

namespace VolumeHaptics
{

/**
 * Returns whether the viewport's window is rendering now, so that an OpenGL context exists, and the
 * viewport has a size that a screen can have. Without a context, for example if an application
 * calls a prop's RenderOverlay itself, VTK's own props would crash. In a viewport whose size
 * overflows an integer, a chart would make labels without end.
 */
inline bool IsDrawing(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  if (!window || !window->CheckInRenderStatus())
  {
    return false;
  }
  constexpr int largest = 1 << 16; // pixels
  const int* const size = viewport->GetSize();
  return size[0] >= 0 && size[0] <= largest && size[1] >= 0 && size[1] <= largest;
}

/**
 * Returns whether the current frame of the viewport's window was abandoned: it will not be shown,
 * so further drawing would only delay the next frame.
 */
inline bool IsGivenUp(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  return window && window->GetAbortRender() != 0;
}

/**
 * Returns whether the viewport's window renders an interactive frame, which is one for which VTK
 * requests more than one frame per second.
 */
inline bool IsMoving(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  return window && window->GetDesiredUpdateRate() > 1.0;
}

} // namespace VolumeHaptics

#endif
