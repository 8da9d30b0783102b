// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes a renderer's aspect ratio, even where VTK 9.1 leaves it uninitialised.
 */
#ifndef RendererAspect_h
#define RendererAspect_h

#include "vtkRenderer.h"

namespace VolumeHaptics
{

/**
 * Computes the aspect ratio of a renderer from its window's size; call it after
 * vtkRenderWindow::AddRenderer().
 *
 * vtkViewport::ComputeAspect() keeps the ratio (at first 1) if the size, the viewport and the pixel
 * aspect are unchanged since its last call. VTK 9.1 leaves these members uninitialised. A renderer
 * in the memory of a deleted one therefore inherits its values, and code that reads the ratio, such
 * as vtkFixedPointVolumeRayCastMapper, draws as if the window were a square. This function sets two
 * different pixel aspects in turn, so that at least one differs from the value in memory.
 */
inline void ComputeAspect(vtkRenderer* renderer)
{
  const double pixel[2] = { renderer->GetPixelAspect()[0], renderer->GetPixelAspect()[1] };
  renderer->SetPixelAspect(2.0 * pixel[0], pixel[1]);
  renderer->ComputeAspect();
  renderer->SetPixelAspect(pixel);
  renderer->ComputeAspect();
}

} // namespace VolumeHaptics

#endif
