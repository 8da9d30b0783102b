// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the volumes of a scene show a moving volume in its felt state.
 *
 * The source of the image reads time steps in advance, so its output is not the felt time step.
 * Volumes that show the felt image get another image instead: the time step nearest to the servo's
 * time.
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

/** Returns whether a shown image is a given image, or has its scalars. */
bool HasSamplesOf(vtkImageData* shown, vtkImageData* image);

class HapticShownTimeSteps
{
public:
  /**
   * Collects the volumes that show the image of a device's filter; call this before time steps are
   * read. The data of such a volume are the image, an image with the same scalars, or if the
   * image's components are time steps, an image of the same shape with one of these components.
   */
  void Collect(vtkRenderer* renderer, vtkHapticDevice* device);
  /**
   * Makes these volumes show the time step at the device's time. Returns whether the time step
   * changed.
   */
  bool Show(vtkHapticDevice* device);
  /** Makes these volumes show their own images again. */
  void Restore();
  /** Returns whether an image is one of the time steps shown here. */
  bool IsPicture(vtkImageData* image) const;

private:
  struct Shown
  {
    vtkWeakPointer<vtkVolume> Volume;
    vtkWeakPointer<vtkVolumeMapper> Mapper;
    vtkWeakPointer<vtkImageData> Image; ///< the application's image
    /** the shown time step; null until one is shown */
    vtkSmartPointer<vtkImageData> Picture;
    /** producer of the mapper's input; kept alive here, because a connection does not keep it */
    vtkSmartPointer<vtkAlgorithm> Before;
    int Port = 0;
  };
  static void Restore(Shown& shown);

  std::vector<Shown> All;
};

} // namespace VolumeHaptics

#endif
