// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether a window is being drawn.
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

} // namespace VolumeHaptics

#endif
