// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets a filter feel what a vtkVolume shows.
 */
#ifndef TouchedVolume_h
#define TouchedVolume_h

#include "VTK/Scene/HapticShownFrames.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

class vtkMatrix4x4;
class vtkVolumeHapticsFilter;
class vtkVolumeMapper;

namespace VolumeHaptics
{

class TouchedVolume
{
public:
  /** The volume that is followed from now on; null for none, which leaves the filter as it is. */
  void Set(vtkVolume* volume) { this->Volume = volume; }
  vtkVolume* Get() const { return this->Volume; }

  /**
   * Gives the filter the volume's image at its place, its opacity, its cropping and its clipping
   * planes, as far as they have changed. Images of a moving volume, which the mapper shows in the
   * place of its own input, are left alone.
   */
  void Update(vtkVolumeHapticsFilter* filter, const HapticShownFrames& pictures);

private:
  void Place(vtkVolumeMapper* mapper, vtkImageData* shown, vtkVolumeHapticsFilter* filter);
  static void Crop(vtkVolumeMapper* mapper, vtkImageData* shown, vtkVolumeHapticsFilter* filter);

  vtkSmartPointer<vtkVolume> Volume;
  vtkNew<vtkImageData> Placed; ///< the image where the volume's matrix puts it
  vtkMTimeType PlacedTime = 0; ///< of the image, when that was placed
};

/**
 * The world position of an image under a matrix, written to another image: origin, spacing and
 * direction. False if voxels are no boxes there, because the matrix shears them.
 */
bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed);

/** The planes of a mapper's regions, along the axes of the data of another image of its shape. */
void MapCropping(
  vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6]);

} // namespace VolumeHaptics

#endif
