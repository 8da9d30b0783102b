// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and checks the time steps of the moving volume that a vtkVolumeHapticsFilter touches.
 */
#ifndef FilterTimeSteps_h
#define FilterTimeSteps_h

#include "VTK/Baking/ImageTimeSteps.h"

#include "vtkType.h"

#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{
class TipPaths;
struct BakedVolume;

/** Returns whether paths pass through the time steps of a filter's input port 0, if it has any. */
bool AreTimeStepsFelt(vtkVolumeHapticsFilter* filter);

/**
 * Makes time steps from the components of the touched array. Makes none if the array is missing;
 * baking then reports the error. Returns false, with the cure in `error`, if the components can't
 * be time steps.
 */
bool CollectComponents(
  vtkVolumeHapticsFilter* filter, std::vector<ImageTimeStep>& timeSteps, std::string& error);

/**
 * Reads the time steps that paths pass through; none if the volume does not move. Returns false,
 * with the cure in `error`, if they can't be read.
 */
bool CollectTimeStepsOfPaths(vtkVolumeHapticsFilter* filter, const TipPaths& paths,
  ImageTimeSteps& timeSteps, std::string& error);

/**
 * Warns once per series of time steps if edges move so far between time steps that blending does
 * not show the motion.
 */
class FastMotionWarning
{
public:
  /**
   * Returns the warning of DescribeFastMotion() for new time steps. Examines at most eight pairs of
   * time steps per call. Returns an empty text after the first warning of a series, or if
   * displacements describe the motion.
   * @param isLoop whether the first time step follows the last one
   */
  std::string Describe(vtkVolumeHapticsFilter* filter, const BakedVolume& volume, bool isLoop);

private:
  /** Key of a series: its source, and the source's modification time (0 for a stream). */
  using SeriesKey = std::pair<const void*, vtkMTimeType>;

  std::vector<std::size_t> ChoosePairs(const BakedVolume& volume, bool isLoop) const;

  SeriesKey Series{ nullptr, 0 };
  double Noise = 0.0;
  bool HasWarned = false;
  std::vector<double> LookedAt; ///< times of the time steps that were examined already
};

} // namespace VolumeHaptics

#endif
