// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The remaining values of an image from which a tool has removed tissue. The image may have fewer
 * samples than the felt volume. This is for small images and parts of images, because each change
 * rewrites all values.
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

/** The tissue that was removed from a volume up to one time, and where the volume is. */
struct RemovedTissue
{
  std::shared_ptr<TissueRemoval> Removal; ///< null: nothing was removed
  vtkSmartPointer<vtkImageData> Volume;   ///< place and extent of the volume, without samples
  vtkMTimeType VolumeTime = 0;            ///< modification time of Volume
  int Component = 0;                      ///< the component that has lost tissue
  double Air = 0.0;                       ///< value of a sample without tissue
  std::uint64_t Changes = 0;              ///< number of changes of the removal's bricks

  bool IsSame(const RemovedTissue& other) const
  {
    return this->Removal == other.Removal && this->Volume == other.Volume &&
      this->VolumeTime == other.VolumeTime && this->Component == other.Component &&
      this->Air == other.Air && this->Changes == other.Changes;
  }
};

/**
 * Returns the tissue that was removed from the whole volume. The samples in memory may be a region
 * of it, or none. The result is empty while all tissue remains, and for a new volume without a
 * model.
 */
RemovedTissue GetRemoved(vtkVolumeHapticsFilter* filter);

/**
 * Collects in `carved` the tissue that was removed from the filter's present volume, without an
 * update. Returns false if no tissue was removed.
 */
bool CollectCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved);

/** Tells which samples of the volume a sample of an image stands for. */
enum class CarvedCover : std::uint8_t
{
  Nearest, ///< the nearest sample
  Voxel    ///< all samples in the image's voxel: their mean is shown
};

/**
 * Writes the remaining values of a part of an image, along x first. If the axes of the image and
 * the volume are not parallel, writes the values of all tissue.
 * @param place  the image, placed in the world of the volume
 * @param whole  the array of the image, with all tissue
 * @param part   the extent to write
 * @param left   an array of the same type
 */
void CopyLeft(const RemovedTissue& removed, CarvedCover cover, vtkImageData* place,
  vtkDataArray* whole, const int part[6], vtkDataArray* left);

/** A copy of an image with the scalars of the remaining tissue. */
class CarvedImage
{
public:
  /**
   * Updates the copy of an image, which may be null. Returns whether the result of Get() has
   * changed. Does not check an image again if it is the same object with the same modification
   * time.
   */
  bool Update(
    vtkImageData* image, vtkImageData* place, const RemovedTissue& removed, CarvedCover cover);
  /**
   * Returns the image itself while nothing is removed; otherwise returns a copy that will not
   * change.
   */
  vtkImageData* Get() const { return this->Left; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkMTimeType Time = 0; ///< time of the image at the last Update
  RemovedTissue Removed;
  vtkSmartPointer<vtkImageData> Left;
};

} // namespace VolumeHaptics

#endif
