// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the volumes of a scene show the felt time step of a moving volume.
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

/** Returns whether a shown image is a given image or has the same scalars. */
bool HasSamplesOf(vtkImageData* shown, vtkImageData* image);

class HapticShownTimeSteps
{
public:
  /**
   * Finds the volumes that show the image of a device's filter. Call this before time steps are
   * read. A volume counts if its data are the image, an image with the same scalars, or, if the
   * image's components are time steps, an image of the same shape with one of these components.
   */
  void Collect(vtkRenderer* renderer, vtkHapticDevice* device);
  /**
   * Makes these volumes show the time step at the device's time. Returns whether the time step has
   * changed.
   */
  bool Show(vtkHapticDevice* device);
  /** Makes these volumes show their own images again. */
  void Restore();
  /** Returns whether an image is a time step shown here. */
  bool IsPicture(vtkImageData* image) const;

private:
  struct Shown
  {
    vtkWeakPointer<vtkVolume> Volume;
    vtkWeakPointer<vtkVolumeMapper> Mapper;
    vtkWeakPointer<vtkImageData> Image; ///< image of the application
    /** Time step that is shown; null until then. */
    vtkSmartPointer<vtkImageData> Picture;
    /** Producer of the mapper's input, owned here because a connection does not own it. */
    vtkSmartPointer<vtkAlgorithm> Before;
    int Port = 0;
  };
  static void Restore(Shown& shown);

  std::vector<Shown> All;
};

} // namespace VolumeHaptics

#endif
