// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets the volumes of a scene show a volume that moves where it is felt.
 *
 * The source of the image is asked for frames ahead of the hand, so that what it has is not what is
 * felt. Volumes that show the felt image get a picture instead, which is the frame that is nearest
 * to the servo's time.
 */
#ifndef HapticShownFrames_h
#define HapticShownFrames_h

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkHapticDevice;
class vtkRenderer;

namespace VolumeHaptics
{

/** Whether a shown image is another one, or has its scalars. */
bool HasSamplesOf(vtkImageData* shown, vtkImageData* image);

class HapticShownFrames
{
public:
  /**
   * To be called before frames are read: finds the volumes that show the image of a device's
   * filter. They have the image, or its scalars; or if its components are frames, an image of its
   * shape with one of them.
   */
  void Find(vtkRenderer* renderer, vtkHapticDevice* device);
  /** Shows the frame at the device's time in them. Whether another one was shown before. */
  bool Show(vtkHapticDevice* device);
  /** Gives them back what they showed. */
  void Restore();
  /** Whether an image is one of the pictures. */
  bool IsPicture(vtkImageData* image) const;

private:
  struct Shown
  {
    vtkWeakPointer<vtkVolume> Volume;
    vtkWeakPointer<vtkVolumeMapper> Mapper;
    vtkWeakPointer<vtkImageData> Image;    ///< that the application shows
    vtkSmartPointer<vtkImageData> Picture; ///< instead; null if it does not move yet
    vtkSmartPointer<vtkAlgorithm> Before;  ///< the mapper's input; its connection keeps no producer
    int Port = 0;
  };
  static void Restore(Shown& shown);

  std::vector<Shown> All;
};

} // namespace VolumeHaptics

#endif
