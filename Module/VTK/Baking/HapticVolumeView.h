// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A VolumeView on the scalars of a vtkImageData, and where the image stands in the world.
 */
#ifndef HapticVolumeView_h
#define HapticVolumeView_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkMatrix4x4;

namespace VolumeHaptics
{

/**
 * False, with the reason and the cure in `error`, where the array can't be viewed without a copy.
 * `holder` has to live as long as the view: the array, or another one that shares its memory. The
 * kernel's radius (voxels) is for the cure.
 */
bool MakeVolumeView(vtkImageData* image, vtkDataArray* scalars, int component, int kernelRadius,
  VolumeView& view, vtkSmartPointer<vtkDataArray>& holder, std::string& error);

/** Points that an image needs along every axis. */
constexpr int PointsNeeded(int kernelRadius)
{
  return 2 * kernelRadius + 1;
}

/**
 * From the index that counts from 0 at the beginning of an extent (the image's own, or that of the
 * whole volume) to the world. False, with an error, for a broken geometry.
 */
bool MakeIndexToWorld(vtkImageData* image, const int extent[6], Affine3& map, std::string& error);

/**
 * From the device (m) to the world. False, with an error, unless the matrix is a rotation, a
 * translation and one uniform, positive scale.
 */
bool ReadSimilarity(vtkMatrix4x4* matrix, Affine3& map, std::string& error);

} // namespace VolumeHaptics

#endif
