// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes coarse images of all of a large volume.
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

/** Geometry of a volume, as in vtkImageData. */
struct VolumePlace
{
  const double* Origin;
  const double* Spacing;
  const double* Direction;
};

/**
 * Averages cubes of n^3 samples to a coarse image, with at most as many voxels as wanted. A volume
 * in chunks is read chunk by chunk, several at once; of any other volume only the middle row of
 * each n^2 rows is read, and the means are of these samples. Throws std::runtime_error if a read
 * fails, std::bad_alloc.
 */
vtkSmartPointer<vtkImageData> AverageVolume(
  const LargeVolume& volume, const VolumePlace& place, vtkIdType mostVoxels);

/**
 * Reads the finest coarser level of a file that is no larger than wanted, with its geometry; null
 * if there is none. Throws like AverageVolume().
 */
vtkSmartPointer<vtkImageData> ReadCoarserLevel(const LargeFile& file, vtkIdType mostVoxels);

} // namespace VolumeHaptics

#endif
