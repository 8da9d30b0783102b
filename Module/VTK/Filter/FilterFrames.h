// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Frames of the moving volume of a vtkVolumeHapticsFilter.
 */
#ifndef FilterFrames_h
#define FilterFrames_h

#include "VTK/Baking/HapticFrames.h"

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

/** Whether paths use the time steps of a filter's input port 0, if it has any. */
bool AreTimeStepsFelt(vtkVolumeHapticsFilter* filter);

/**
 * Makes frames of the components of the touched array; none if the array is missing, an error that
 * baking reports. False, with the cure in `error`, if the components can't be frames.
 */
bool CollectComponents(
  vtkVolumeHapticsFilter* filter, std::vector<HapticFrame>& frames, std::string& error);

/**
 * Reads the frames that paths need; none if the volume does not move. False, with the cure in
 * `error`, if they can't be read.
 */
bool CollectFramesOfPaths(
  vtkVolumeHapticsFilter* filter, const TipPaths& paths, HapticFrames& frames, std::string& error);

/**
 * Warns once for each series of frames if edges move too far between two frames for a blend to show
 * the motion.
 */
class FastMotionWarning
{
public:
  /**
   * Calls DescribeFastMotion() for new frames, eight at most. Always empty after the first warning
   * of a series, and if displacements describe the motion.
   * @param isLoop whether the first frame follows the last one
   */
  std::string Describe(vtkVolumeHapticsFilter* filter, const BakedVolume& volume, bool isLoop);

private:
  /** A source, and its change time unless it is a stream. */
  using SeriesKey = std::pair<const void*, vtkMTimeType>;

  std::vector<std::size_t> ChoosePairs(const BakedVolume& volume, bool isLoop) const;

  SeriesKey Series{ nullptr, 0 };
  double Noise = 0.0;
  bool HasWarned = false;
  std::vector<double> LookedAt; ///< times of the frames that were examined
};

} // namespace VolumeHaptics

#endif
