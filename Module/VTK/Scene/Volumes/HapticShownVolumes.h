// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the volumes of a scene that show the felt image differently from how it is felt.
 */
#ifndef HapticShownVolumes_h
#define HapticShownVolumes_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkRenderer;
class vtkUnsignedCharArray;
class vtkVolume;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class CarvedPictures;
class HapticShownTimeSteps;
struct DrawnVolume;

/** Warns of volumes that are shown otherwise than felt, of each difference once while it lasts. */
class HapticShownVolumes
{
public:
  /**
   * Returns a warning for each visible volume of a renderer that shows the image, or an image with
   * the same scalars, otherwise than the filter feels it. It names the new differences since the
   * last call, and the cures. These volumes also count as showing the image: time steps of a moving
   * volume, copies of what a tool has left of it, and the followed volume.
   */
  std::vector<std::string> Check(vtkRenderer* renderer, vtkImageData* image,
    vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
    const CarvedPictures& carved, vtkVolume* followed);

private:
  struct Known
  {
    vtkWeakPointer<vtkVolume> Volume;
    unsigned int Differences;
  };
  unsigned int DetectDifferences(const DrawnVolume& drawn, vtkImageData* image,
    vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
    const CarvedPictures& carved, vtkVolume* followed);
  /** Counts blanks in the drawn data: cells alone, or points and cells. */
  bool HasBlanks(vtkImageData* image, bool areCells);
  bool HasBlanks(vtkUnsignedCharArray* ghosts, int hidden, int which);
  /** Whether the followed volume is opaque up to all faces of its image. */
  bool IsFull(vtkImageData* image, vtkVolumeHapticsFilter* filter);

  std::vector<Known> All;
  struct Blanks
  {
    vtkWeakPointer<vtkUnsignedCharArray> Ghosts;
    vtkMTimeType Time = 0;
    bool HasAny = false;
  };
  Blanks Last[2]; ///< the blanks of points and of cells; stored, because counting takes a pass over
                  ///< the image
  struct Filled
  {
    vtkMTimeType Time = 0;
    bool IsTrue = false;
  };
  Filled LastFilled; ///< state of the followed volume
};

} // namespace VolumeHaptics

#endif
