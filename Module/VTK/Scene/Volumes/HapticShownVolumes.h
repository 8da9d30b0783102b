// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects volumes of a scene that look different from how they are felt.
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

/**
 * Warns of volumes that are shown differently from how they are felt, once per difference while it
 * lasts.
 */
class HapticShownVolumes
{
public:
  /**
   * Returns a warning for each visible volume of a renderer that shows the image, or an image with
   * the same scalars, differently from how the filter feels it. A warning names the differences
   * that are new since the last call, with their cures. Time steps of a moving volume, copies with
   * the remaining tissue, and the followed volume also count as showing the image.
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
  /**
   * Returns whether the drawn data have blanked cells, or, if points are drawn, blanked points or
   * cells. With `byAnyFlag`, any other ghost flag counts, too.
   */
  bool HasBlanks(vtkImageData* image, bool areCells, bool byAnyFlag);
  /** Returns whether the followed volume is opaque up to all faces of its image. */
  bool IsFull(vtkImageData* image, vtkVolumeHapticsFilter* filter);

  std::vector<Known> All;
  struct Blanks
  {
    vtkWeakPointer<vtkUnsignedCharArray> Ghosts;
    vtkMTimeType Time = 0;
    int Flags = 0;
  };
  /** Flags of points and of cells, cached because collecting them takes a pass over the image. */
  Blanks Last[2];
  struct Filled
  {
    vtkMTimeType Time = 0;
    bool IsTrue = false;
  };
  Filled LastFilled; ///< whether the followed volume is opaque on all faces
};

} // namespace VolumeHaptics

#endif
