// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether a window is being drawn, and whether the picture will be shown.
 */
#ifndef HapticDrawing_h
#define HapticDrawing_h

#include "vtkRenderWindow.h"
#include "vtkViewport.h"

namespace VolumeHaptics
{

/**
 * Whether the viewport's window renders now, so that OpenGL has a context. Otherwise, for example
 * if an application calls a prop's RenderOverlay itself, VTK's own props would crash.
 */
inline bool IsDrawing(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  return window && window->CheckInRenderStatus();
}

/**
 * Whether the frame of the viewport's window was given up: it will not be shown, and further
 * drawing would only delay the next frame.
 */
inline bool IsGivenUp(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  return window && window->GetAbortRender() != 0;
}

/**
 * Whether the viewport's window draws a frame of a motion: its desired rate is above one a second.
 */
inline bool IsMoving(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  return window && window->GetDesiredUpdateRate() > 1.0;
}

} // namespace VolumeHaptics

#endif
