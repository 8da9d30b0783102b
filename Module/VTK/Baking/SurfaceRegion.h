// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceRegion_h
#define SurfaceRegion_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <memory>

namespace VolumeHaptics
{
class SurfaceMesh;

/** A part of an image, as vtkHapticRegionFilter makes it, and the isosurface in it. */
struct SurfaceRegion
{
  vtkSmartPointer<vtkImageData> Image;
  std::shared_ptr<const SurfaceMesh> Mesh; ///< null if the region contains no surface
};

} // namespace VolumeHaptics

#endif
