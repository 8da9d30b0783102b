// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frames of a vtkVolumeHapticsFilter's volume that moves.
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

/** Whether paths go through the time steps of a filter's input port 0, if it has any. */
bool AreTimeStepsFelt(vtkVolumeHapticsFilter* filter);

/**
 * The components of the touched array as frames; none if the array is missing, which baking tells.
 * False, with the cure in `error`, if they can't be frames.
 */
bool CollectComponents(
  vtkVolumeHapticsFilter* filter, std::vector<HapticFrame>& frames, std::string& error);

/**
 * The frames that paths need; none if the volume does not move. False, with the cure in `error`, if
 * they can't be had.
 */
bool CollectFramesOfPaths(
  vtkVolumeHapticsFilter* filter, const TipPaths& paths, HapticFrames& frames, std::string& error);

/**
 * Warns once for a series of frames if edges move too far between two of them for a blend to show
 * the motion.
 */
class FastMotionWarning
{
public:
  /**
   * DescribeFastMotion() of frames that it has not looked at yet, eight at most; always empty after
   * one warning of a series, and where displacements tell the motion.
   * @param isLoop whether the first frame follows the last one
   */
  std::string Describe(vtkVolumeHapticsFilter* filter, const BakedVolume& volume, bool isLoop);

private:
  /** A source, and the time of its change unless it is a stream. */
  using SeriesKey = std::pair<const void*, vtkMTimeType>;

  std::vector<std::size_t> ChoosePairs(const BakedVolume& volume, bool isLoop) const;

  SeriesKey Series{ nullptr, 0 };
  double Noise = 0.0;
  bool HasWarned = false;
  std::vector<double> LookedAt; ///< the times of frames
};

} // namespace VolumeHaptics

#endif
