// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes a renderer's aspect ratio also where VTK 9.1 leaves it uninitialised.
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
 * aspect equal those of its last call. VTK 9.1 leaves these uninitialised: a renderer in the memory
 * of a deleted renderer has the deleted one's values, and users of the ratio, such as
 * vtkFixedPointVolumeRayCastMapper, draw as if the window were a square. Setting two different
 * pixel aspects makes at least one differ from the value in memory.
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
