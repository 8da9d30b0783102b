// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes an image's values after a tool has removed tissue from the felt volume. The image may
 * have fewer samples than that volume. This is for small images and parts of images, because each
 * change rewrites all values.
 */
#ifndef CarvedImage_h
#define CarvedImage_h

#include "VTK/Scene/Volumes/CarvedArray.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** The tissue removed from a volume so far, with the volume's position. */
struct RemovedTissue
{
  std::shared_ptr<TissueRemoval> Removal; ///< null if no tissue was removed
  vtkSmartPointer<vtkImageData> Volume;   ///< geometry of the volume, without samples
  vtkMTimeType VolumeTime = 0;            ///< modification time of Volume
  int Component = 0;                      ///< component whose tissue was removed
  double Air = 0.0;                       ///< value of a sample whose tissue was removed
  std::uint64_t Changes = 0;              ///< number of changes to the removal's bricks

  bool IsSame(const RemovedTissue& other) const
  {
    return this->Removal == other.Removal && this->Volume == other.Volume &&
      this->VolumeTime == other.VolumeTime && this->Component == other.Component &&
      this->Air == other.Air && this->Changes == other.Changes;
  }
};

/**
 * Returns the tissue removed from the whole volume, of which the samples in memory may be a region,
 * or none. Empty while all tissue remains, and for a new volume without a model.
 */
RemovedTissue GetRemoved(vtkVolumeHapticsFilter* filter);

/**
 * Collects the tissue removed from the filter's present volume into `carved`, without an update.
 * Returns false if no tissue was removed.
 */
bool CollectCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved);

/** Which samples of the volume a sample of an image represents. */
enum class CarvedCover : std::uint8_t
{
  Nearest, ///< the nearest sample
  Voxel    ///< all samples in the image's voxel, of which the mean is shown
};

/**
 * Writes the values of a part of an image with the remaining tissue, x fastest. If the axes of the
 * image and the volume are not parallel, writes the values of all tissue.
 * @param place  the image, placed in the world of the volume
 * @param whole  the image's array, with all tissue
 * @param part   the extent to write
 * @param left   an array of the same type
 */
void CopyLeft(const RemovedTissue& removed, CarvedCover cover, vtkImageData* place,
  vtkDataArray* whole, const int part[6], vtkDataArray* left);

/** A copy of an image whose scalars show the remaining tissue. */
class CarvedImage
{
public:
  /**
   * Updates the copy of an image, which may be null. Returns whether the result of Get() has
   * changed. Skips an image if it is the same object with the same modification time.
   */
  bool Update(
    vtkImageData* image, vtkImageData* place, const RemovedTissue& removed, CarvedCover cover);
  /** Returns the image itself while nothing is removed; otherwise a copy that will not change. */
  vtkImageData* Get() const { return this->Left; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkMTimeType Time = 0; ///< modification time of the image at the last Update()
  RemovedTissue Removed;
  vtkSmartPointer<vtkImageData> Left;
};

} // namespace VolumeHaptics

#endif
