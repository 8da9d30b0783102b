// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a vtkImageData for Core: the scalars, their place in the world, and the facts about the
 * whole volume if the image is a region of it.
 */
#ifndef HapticVolume_h
#define HapticVolume_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"
#include "VTK/Baking/WholeFacts.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace VolumeHaptics
{

/** One component of an image. */
struct HapticVolume
{
  VolumeView View;                      ///< counts its indices as the whole volume does
  vtkSmartPointer<vtkDataArray> Holder; ///< keeps the memory of View
  Affine3 IndexToWorld;                 ///< from View's indices
  WholeFacts Whole;
};

/**
 * Reads a component of an image without a copy. False, with the reason and the cure in `error`, if
 * the array can't be viewed, or the geometry or the field arrays are invalid. The error's cure
 * needs the kernel's radius (voxels).
 */
bool ReadVolume(vtkImageData* image, vtkDataArray* scalars, int component, int kernelRadius,
  HapticVolume& volume, std::string& error);

/** The smallest spacing of an image (world units). */
double SmallestSpacing(vtkImageData* image);

/** The number of points that an image needs along every axis. */
constexpr int PointsNeeded(int kernelRadius)
{
  return 2 * kernelRadius + 1;
}

} // namespace VolumeHaptics

#endif
