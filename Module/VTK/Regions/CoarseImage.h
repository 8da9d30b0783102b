// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes coarse images of a large volume.
 */
#ifndef CoarseImage_h
#define CoarseImage_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"
#include "VTK/Regions/Formats/LargeFile.h"
#include "VTK/Regions/Formats/LargeVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>

namespace VolumeHaptics
{

/**
 * A coarse image in memory that stands in for samples of a large volume that are not read in time.
 *
 * It is immutable, so threads can share it. The owner's thread must release the last reference.
 */
class CoarseLevel
{
public:
  /**
   * Makes the level from the first component of an image's scalars. `indexToWorld` is the transform
   * of the large volume, in the same world as the image. Fills samples that DetectOutside() finds,
   * unless the scalars are labels. Returns null, with the reason and the cure in `error`, if there
   * are no scalars or if the image can't be used.
   */
  static std::shared_ptr<const CoarseLevel> Make(
    vtkImageData* image, bool areLabels, const Affine3& indexToWorld, std::string& error);

  /**
   * Fills a box of the volume (x fastest) with samples of a VTK type. Interpolates linearly between
   * the samples of the image, and rounds for integer types. Beyond the image, uses the nearest
   * border sample.
   */
  void Fill(const BoxExtent& box, int scalarType, void* samples) const;

private:
  CoarseLevel() = default;
  template <typename T>
  void FindRow(const BoxExtent& box, int j, int k, double* values) const;

  VolumeView View;
  vtkSmartPointer<vtkDataArray> Holder;
  Affine3 FromVolume; ///< maps indices of the volume to indices of View
};

/** Geometry of a volume, in the terms of vtkImageData. */
struct VolumePlace
{
  const double* Origin;
  const double* Spacing;
  const double* Direction;
};

/**
 * Averages cubes of n^3 samples to a coarse image of at most mostVoxels voxels. A chunked volume is
 * read chunk by chunk, several at once. For any other volume, only one row in the middle of each
 * n^2 rows is read and averaged. Throws std::runtime_error if a read fails, and std::bad_alloc.
 */
vtkSmartPointer<vtkImageData> AverageVolume(
  const LargeVolume& volume, const VolumePlace& place, vtkIdType mostVoxels);

/**
 * Reads the finest coarser level in a file that has at most mostVoxels voxels, with its geometry.
 * Returns null if there is none. Throws the same exceptions as AverageVolume().
 */
vtkSmartPointer<vtkImageData> ReadCoarserLevel(const LargeFile& file, vtkIdType mostVoxels);

} // namespace VolumeHaptics

#endif
