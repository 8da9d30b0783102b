// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a vtkImageData for Core: the scalars, their position in the world, and the facts about the
 * whole volume if the image is a region of it.
 */
#ifndef HapticVolume_h
#define HapticVolume_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"
#include "VTK/Base/WholeFacts.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace VolumeHaptics
{

/** One component of an image, with its position in the world. */
struct HapticVolume
{
  VolumeView View;                      ///< addressed by the indices of the whole volume
  vtkSmartPointer<vtkDataArray> Holder; ///< owns the memory that View points to
  Affine3 IndexToWorld;                 ///< maps indices of View to the world
  WholeFacts Whole;
};

/**
 * Makes a view of a component of an image without a copy. Returns false, with the reason and the
 * cure in `error`, if the array can't be viewed, or if the geometry or the field arrays are
 * invalid. `kernelRadius` (voxels) appears in the cure.
 */
bool ReadVolume(vtkImageData* image, vtkDataArray* scalars, int component, int kernelRadius,
  HapticVolume& volume, std::string& error);

/**
 * Makes a view of a component's samples without a copy. Returns false for an unsupported type or
 * memory layout. `holder` must outlive the view: it is the array, or an array that shares its
 * memory. The view's Data is null if the component has no memory.
 */
bool LocateSamples(vtkDataArray* scalars, int component, const int dimensions[3], VolumeView& view,
  vtkSmartPointer<vtkDataArray>& holder);

/**
 * Computes the map to the world for indices that start at the lower corner of an extent. Returns
 * false, and names the image by `name` in `error`, if there is no such map.
 */
bool MakeIndexToWorld(
  vtkImageData* image, const int extent[6], const char* name, Affine3& map, std::string& error);

/** Returns the name of an array for error texts, such as: array "Density". */
std::string DescribeArray(vtkDataArray* scalars);

/** Returns the smallest spacing of an image (world units). */
double SmallestSpacing(vtkImageData* image);

/**
 * Returns the smallest number of points that an image needs along each axis for a gradient kernel
 * of this radius.
 */
constexpr int PointsNeeded(int kernelRadius)
{
  return 2 * kernelRadius + 1;
}

} // namespace VolumeHaptics

#endif
