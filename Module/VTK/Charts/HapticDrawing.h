// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether there is something to draw to.
 */
#ifndef HapticDrawing_h
#define HapticDrawing_h

#include "vtkRenderWindow.h"
#include "vtkViewport.h"

namespace VolumeHaptics
{

/**
 * Whether the viewport's window renders now. OpenGL has a context then; elsewhere, as where an
 * application calls a prop's RenderOverlay by itself, VTK's own props would crash.
 */
inline bool IsDrawing(vtkViewport* viewport)
{
  auto* const window = viewport ? vtkRenderWindow::SafeDownCast(viewport->GetVTKWindow()) : nullptr;
  return window && window->CheckInRenderStatus();
}

} // namespace VolumeHaptics

#endif
