// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets a filter feel what a vtkVolume shows.
 */
#ifndef TouchedVolume_h
#define TouchedVolume_h

#include "VTK/Scene/CarvedPictures.h"
#include "VTK/Scene/HapticShownFrames.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkAlgorithmOutput;
class vtkHapticLabelTable;
class vtkVolumeHapticsFilter;
class vtkVolumeMapper;

namespace VolumeHaptics
{

struct DrawnVolume;

class TouchedVolume
{
public:
  TouchedVolume();
  ~TouchedVolume();

  /** The volume that is followed from now on; null for none, which leaves the filter as it is. */
  void Set(vtkVolume* volume) { this->Volume = volume; }
  vtkVolume* Get() const { return this->Volume; }

  /**
   * Looks for the volume among those that are drawn, which say where it is; false if it is none of
   * them. Then it is where its own matrix puts it.
   */
  bool FindPlace(const std::vector<DrawnVolume>& drawn);

  /** Takes the labels of its mask out of the filter. */
  void TakeBack(vtkVolumeHapticsFilter* filter);

  /**
   * Gives the filter the volume's image at its place, its opacity, its cropping, its clipping
   * planes and its binary mask, as far as they have changed. Images of a moving volume, which the
   * mapper shows in the place of its own input, are left alone, and so are labels of the filter.
   * A copy that shows what a tool has left of the image stands for the image.
   */
  void Update(vtkVolumeHapticsFilter* filter, const HapticShownFrames& pictures,
    const CarvedPictures& carved);

private:
  void Place(vtkAlgorithmOutput* input, vtkImageData* shown, vtkVolumeHapticsFilter* filter);
  static void Crop(vtkVolumeMapper* mapper, vtkImageData* shown, vtkVolumeHapticsFilter* filter);
  /** A mask becomes a label image, of which the label 0 is not felt. */
  void Mask(vtkVolumeMapper* mapper, vtkVolumeHapticsFilter* filter);

  vtkSmartPointer<vtkVolume> Volume;
  vtkNew<vtkMatrix4x4> Matrix; ///< from the data to the world
  vtkNew<vtkImageData> Placed; ///< the image where the volume's matrix puts it
  vtkMTimeType PlacedTime = 0; ///< of the image, when that was placed
  vtkNew<vtkImageData> Labels; ///< the mask where the image is
  vtkWeakPointer<vtkImageData> MaskImage;
  vtkMTimeType MaskTime = 0; ///< of the mask, when it became labels
  vtkSmartPointer<vtkHapticLabelTable> Unfelt;
};

/**
 * The world position of an image under a matrix, written to another image: origin, spacing and
 * direction. False if voxels are no boxes there, because the matrix shears them.
 */
bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed);

/** The mask by which a mapper hides voxels; null if there is none of this kind. */
vtkImageData* FindBinaryMask(vtkVolumeMapper* mapper);

/** The planes of a mapper's regions, along the axes of the data of another image of its shape. */
void MapCropping(
  vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6]);

} // namespace VolumeHaptics

#endif
