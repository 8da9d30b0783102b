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

/** One component of an image. */
struct HapticVolume
{
  VolumeView View;                      ///< its indices are indices of the whole volume
  vtkSmartPointer<vtkDataArray> Holder; ///< keeps the memory of View alive
  Affine3 IndexToWorld;                 ///< maps View's indices to the world
  WholeFacts Whole;
};

/**
 * Reads a component of an image without a copy. Returns false, with the reason and the cure in
 * `error`, if the array can't be viewed, or the geometry or the field arrays are invalid.
 * `kernelRadius` (voxels) is stated in the cure.
 */
bool ReadVolume(vtkImageData* image, vtkDataArray* scalars, int component, int kernelRadius,
  HapticVolume& volume, std::string& error);

/**
 * Views the samples of a component without a copy. Returns false if the type or the memory layout
 * of the array is unsupported. `holder` has to live as long as the view: it is the array, or an
 * array that shares its memory. The view's Data is null if the component has no memory.
 */
bool LocateSamples(vtkDataArray* scalars, int component, const int dimensions[3], VolumeView& view,
  vtkSmartPointer<vtkDataArray>& holder);

/**
 * Computes the map to the world from indices that count from the beginning of an extent. Returns
 * false if there is no such map; `error` then names the image by `name`.
 */
bool MakeIndexToWorld(
  vtkImageData* image, const int extent[6], const char* name, Affine3& map, std::string& error);

/** Returns the name of an array for errors, such as: array "Density". */
std::string DescribeArray(vtkDataArray* scalars);

/** Returns the smallest spacing of an image (world units). */
double SmallestSpacing(vtkImageData* image);

/** Returns the smallest number of points along each axis that an image must have. */
constexpr int PointsNeeded(int kernelRadius)
{
  return 2 * kernelRadius + 1;
}

} // namespace VolumeHaptics

#endif
