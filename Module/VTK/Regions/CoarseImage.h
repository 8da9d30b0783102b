// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Images of all of a large volume with coarser voxels.
 */
#ifndef CoarseImage_h
#define CoarseImage_h

#include "VTK/Regions/Formats/LargeFile.h"
#include "VTK/Regions/Formats/LargeVolume.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

namespace VolumeHaptics
{

/** Where a volume lies, as that of vtkImageData. */
struct VolumePlace
{
  const double* Origin;
  const double* Spacing;
  const double* Direction;
};

/**
 * Means of cubes of n^3 samples, at most as many as are wanted. A volume in chunks is read chunk by
 * chunk, several at once; of another one the row in the middle of each n^2 is read, and the means
 * are of these. Throws std::runtime_error if a read fails, std::bad_alloc.
 */
vtkSmartPointer<vtkImageData> AverageVolume(
  const LargeVolume& volume, const VolumePlace& place, vtkIdType mostVoxels);

/**
 * Reads the finest one of the coarser levels of a file that is no larger than wanted, with its
 * place in the world; null if there is none. Throws as AverageVolume.
 */
vtkSmartPointer<vtkImageData> ReadCoarserLevel(const LargeFile& file, vtkIdType mostVoxels);

} // namespace VolumeHaptics

#endif
