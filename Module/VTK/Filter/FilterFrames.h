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

/** Looks at each series of frames once. */
class FastMotionWarning
{
public:
  /** DescribeFastMotion() at the first call for a series, and empty afterwards. */
  std::string Describe(
    vtkVolumeHapticsFilter* filter, vtkImageData* image, const BakedVolume& volume);

private:
  /** A source and its time of change. */
  using SeriesKey = std::pair<const void*, vtkMTimeType>;
  SeriesKey LookedAt{ nullptr, 0 };
};

} // namespace VolumeHaptics

#endif
