// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Time steps of the moving volume of a vtkVolumeHapticsFilter.
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

/** Returns whether paths use the time steps of a filter's input port 0, if it has any. */
bool AreTimeStepsFelt(vtkVolumeHapticsFilter* filter);

/**
 * Makes time steps of the components of the touched array. Makes none if the array is missing,
 * which baking reports as an error. Returns false, with the cure in `error`, if the components
 * can't be time steps.
 */
bool CollectComponents(
  vtkVolumeHapticsFilter* filter, std::vector<ImageTimeStep>& timeSteps, std::string& error);

/**
 * Reads the time steps that paths need, or none if the volume does not move. Returns false, with
 * the cure in `error`, if they can't be read.
 */
bool CollectTimeStepsOfPaths(vtkVolumeHapticsFilter* filter, const TipPaths& paths,
  ImageTimeSteps& timeSteps, std::string& error);

/**
 * Warns once for each series of time steps if edges move so far from one time step to the next that
 * a blend does not show the motion.
 */
class FastMotionWarning
{
public:
  /**
   * Returns the text of DescribeFastMotion() for new time steps. Each call examines at most eight
   * pairs of time steps. Returns an empty text after the first warning of a series, and if
   * displacements describe the motion.
   * @param isLoop whether the first time step follows the last one
   */
  std::string Describe(vtkVolumeHapticsFilter* filter, const BakedVolume& volume, bool isLoop);

private:
  /** Identifies a series: its source, and the source's modification time (0 for a stream). */
  using SeriesKey = std::pair<const void*, vtkMTimeType>;

  std::vector<std::size_t> ChoosePairs(const BakedVolume& volume, bool isLoop) const;

  SeriesKey Series{ nullptr, 0 };
  double Noise = 0.0;
  bool HasWarned = false;
  std::vector<double> LookedAt; ///< times of the time steps that were examined
};

} // namespace VolumeHaptics

#endif
