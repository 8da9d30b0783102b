// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The remaining values of an image from which a tool has removed tissue; the image may have fewer
 * samples than the felt volume. For small images and parts of images: each change writes all values
 * anew.
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

/** The tissue removed from a volume at one time, and its place. */
struct RemovedTissue
{
  std::shared_ptr<TissueRemoval> Removal; ///< null: nothing
  vtkSmartPointer<vtkImageData> Volume;   ///< place and extent of the volume, without samples
  vtkMTimeType VolumeTime = 0;            ///< time of Volume
  int Component = 0;                      ///< the component that has lost tissue
  double Air = 0.0;                       ///< value of a sample without tissue
  std::uint64_t Changes = 0;              ///< number of the bricks' changes

  bool IsSame(const RemovedTissue& other) const
  {
    return this->Removal == other.Removal && this->Volume == other.Volume &&
      this->VolumeTime == other.VolumeTime && this->Component == other.Component &&
      this->Air == other.Air && this->Changes == other.Changes;
  }
};

/**
 * Returns the removed tissue of the whole volume; the samples in memory may be a region of it, or
 * none. Empty while all tissue remains, and for a new volume without a model.
 */
RemovedTissue GetRemoved(vtkVolumeHapticsFilter* filter);

/**
 * Collects in `carved` what was removed from the filter's present volume, without an update. False
 * if no tissue was removed from it.
 */
bool CollectCarved(vtkVolumeHapticsFilter* filter, CarvedArray& carved);

/** The tissue of the volume that a sample of an image stands for. */
enum class CarvedCover : std::uint8_t
{
  Nearest, ///< the nearest sample of the volume
  Voxel    ///< the mean of the volume's samples in the sample's voxel
};

/**
 * Writes the remaining values of a part of an image, x first. All tissue remains if the axes of the
 * image and the volume are not parallel.
 * @param place  the image where it lies in the world of the volume
 * @param whole  its array, with all tissue
 * @param part   the extent to write
 * @param left   an array of the same type
 */
void CopyLeft(const RemovedTissue& removed, CarvedCover cover, vtkImageData* place,
  vtkDataArray* whole, const int part[6], vtkDataArray* left);

/** An image with scalars of the remaining tissue. */
class CarvedImage
{
public:
  /**
   * Updates the copy of an image, which may be null. Returns whether Get() is a new image. An image
   * that is the same object with the same time is not checked again.
   */
  bool Update(
    vtkImageData* image, vtkImageData* place, const RemovedTissue& removed, CarvedCover cover);
  /**
   * Returns the image itself while nothing is removed; otherwise a copy, which no longer changes.
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
