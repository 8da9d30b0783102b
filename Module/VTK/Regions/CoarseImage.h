// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes coarse images of a whole large volume.
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
 * A coarse image in memory that replaces late samples of a large volume.
 *
 * It never changes, so that threads can share it. The owner releases the last reference.
 */
class CoarseLevel
{
public:
  /**
   * Makes the level from the first component of an image's scalars. `indexToWorld` is the transform
   * of the volume that the image replaces, in the same world. Samples that DetectOutside() finds
   * are filled, unless the scalars are labels. Returns null, with reason and cure in `error`, if
   * there are no scalars or if the image can't be used.
   */
  static std::shared_ptr<const CoarseLevel> Make(
    vtkImageData* image, bool areLabels, const Affine3& indexToWorld, std::string& error);

  /**
   * Fills a box of the volume, x fastest, with samples of a VTK type. Between the samples of the
   * image, values are trilinear, and rounded for integer types. Beyond the image, they are equal
   * to the nearest border sample.
   */
  void Fill(const BoxExtent& box, int scalarType, void* samples) const;

private:
  CoarseLevel() = default;
  template <typename T>
  void FindRow(const BoxExtent& box, int j, int k, double* values) const;

  VolumeView View;
  vtkSmartPointer<vtkDataArray> Holder;
  Affine3 FromVolume; ///< maps an index of the volume to an index of View
};

/** Geometry of a volume, as in vtkImageData. */
struct VolumePlace
{
  const double* Origin;
  const double* Spacing;
  const double* Direction;
};

/**
 * Averages cubes of n^3 samples to a coarse image of at most mostVoxels voxels. A volume in chunks
 * is read chunk by chunk, several at once. Of any other volume, only the middle row of each n^2
 * rows is read and averaged. Throws std::runtime_error if a read fails, and std::bad_alloc.
 */
vtkSmartPointer<vtkImageData> AverageVolume(
  const LargeVolume& volume, const VolumePlace& place, vtkIdType mostVoxels);

/**
 * Reads the finest coarser level of a file that has at most mostVoxels voxels, with its geometry.
 * Returns null if there is none. Throws like AverageVolume().
 */
vtkSmartPointer<vtkImageData> ReadCoarserLevel(const LargeFile& file, vtkIdType mostVoxels);

} // namespace VolumeHaptics

#endif
