// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the volumes of a scene show a moving volume in its felt state.
 *
 * The source of the image reads time steps ahead of the hand, so its output is not the felt time
 * step. Volumes that show the felt image get a picture instead: the time step nearest to the
 * servo's time.
 */
#ifndef HapticShownTimeSteps_h
#define HapticShownTimeSteps_h

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

/** Whether a shown image is the given image, or has its scalars. */
bool HasSamplesOf(vtkImageData* shown, vtkImageData* image);

class HapticShownTimeSteps
{
public:
  /**
   * Finds the volumes that show the image of a device's filter; call this before time steps are
   * read. Such a volume has the image, or its scalars; or if the image's components are time steps,
   * an image of its shape with one of them.
   */
  void Collect(vtkRenderer* renderer, vtkHapticDevice* device);
  /**
   * Shows the time step at the device's time in these volumes. Returns whether the time step
   * changed.
   */
  bool Show(vtkHapticDevice* device);
  /** Restores what the volumes showed. */
  void Restore();
  /** Whether an image is one of the pictures made here. */
  bool IsPicture(vtkImageData* image) const;

private:
  struct Shown
  {
    vtkWeakPointer<vtkVolume> Volume;
    vtkWeakPointer<vtkVolumeMapper> Mapper;
    vtkWeakPointer<vtkImageData> Image;    ///< the application's image
    vtkSmartPointer<vtkImageData> Picture; ///< shown now; null if the volume does not move yet
    vtkSmartPointer<vtkAlgorithm> Before;  ///< the mapper's input; its connection keeps no producer
    int Port = 0;
  };
  static void Restore(Shown& shown);

  std::vector<Shown> All;
};

} // namespace VolumeHaptics

#endif
