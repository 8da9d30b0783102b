// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is left of an image from which a tool has removed tissue, also if its samples are fewer than
 * those of the volume that is felt. For small images and parts of images: each change writes all
 * of it anew.
 */
#ifndef CarvedImage_h
#define CarvedImage_h

#include "VTK/Scene/Volumes/FilterCarving.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>

namespace VolumeHaptics
{

/** Which tissue of the volume a sample of an image stands for. */
enum class CarvedCover : std::uint8_t
{
  Nearest, ///< that of the nearest sample of the volume
  Voxel    ///< the mean of all samples of the volume that are in its voxel
};

/**
 * Writes what is left of the samples of a part of an image, x first. All of them, where the axes of
 * the image and the volume are not parallel.
 * @param place  the image where it lies in the world of the volume
 * @param whole  its array, with all tissue
 * @param part   the extent to write
 * @param left   an array of the same type
 */
void CopyLeft(const RemovedTissue& removed, CarvedCover cover, vtkImageData* place,
  vtkDataArray* whole, const int part[6], vtkDataArray* left);

/** An image with its scalars, as far as a tool has left of them. */
class CarvedImage
{
public:
  /**
   * Follows an image, which may be null; whether Get() is another one than before. An image that is
   * the same object with the same time is not looked at again.
   */
  bool Follow(
    vtkImageData* image, vtkImageData* place, const RemovedTissue& removed, CarvedCover cover);
  /** The image itself as long as nothing was removed; otherwise a copy, which no longer changes. */
  vtkImageData* Get() const { return this->Left; }

private:
  vtkSmartPointer<vtkImageData> Image;
  vtkMTimeType Time = 0; ///< of the image, when it was followed
  RemovedTissue Removed;
  vtkSmartPointer<vtkImageData> Left;
};

} // namespace VolumeHaptics

#endif
