// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Joins time spans of a volume whose time steps arrive one by one, so that the volume does not
 * jump.
 */
#ifndef StreamedTimeSpan_h
#define StreamedTimeSpan_h

#include "Core/Model/BakedVolume.h"
#include "VTK/Device/Playback/HapticChangeTime.h"

#include "vtkType.h"
#include "vtkVolumeHapticsFilter.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Identifies the source of a filter's time steps. While this is unchanged, samples that were read
 * remain valid, because only settings can have changed.
 */
struct TimeStepOrigin
{
  const void* Connection = nullptr; ///< connection to the source, used only for comparison
  vtkMTimeType Time = 0;            ///< modification time of the source and its pipeline
  std::string Displacements;        ///< name of the displacement array

  bool operator==(const TimeStepOrigin& other) const
  {
    return this->Connection == other.Connection && this->Time == other.Time &&
      this->Displacements == other.Displacements;
  }
};

inline TimeStepOrigin GetTimeStepOrigin(vtkVolumeHapticsFilter* filter)
{
  return { filter->GetInputConnection(0, 0), ComputePipelineTime(filter->GetInputAlgorithm(0, 0)),
    filter->GetDisplacementArrayName() };
}

/**
 * Earlier time spans of a moving volume. While the servo uses one of them, the time steps of that
 * time span stay in memory.
 */
class PastTimeSpans
{
public:
  void Record(const std::shared_ptr<const BakedVolume>& span);
  /**
   * Returns whether no earlier time span is in use. Also returns true if a reader of states has
   * kept one in use for too long.
   */
  bool AreGone() const;

private:
  std::vector<std::weak_ptr<const BakedVolume>> Spans;
  std::int64_t Since = 0; ///< time (ns) at which the last time span was added
};

/** Returns a time step of a time span in the form that another time span needs. */
VolumeTimeStep KeepTimeStep(const BakedVolume& span, std::size_t number);

/**
 * Returns whether the time steps at the times `next` give the same volume at `time` as those at the
 * times `last`. Both lists are ascending. Time steps at equal times are assumed to be equal, so
 * this holds at a time that both lists contain, and between two neighbouring times that both
 * contain.
 */
bool GoesOnWith(const std::vector<double>& last, const std::vector<double>& next, double time);

/**
 * Returns `next` with the two time steps of `last` around a time added, unless `next` already has
 * them. The volume then continues from its present shape without a jump, even if time steps were
 * skipped. Both time spans must be whole series of one volume, with the first time step repeated at
 * the end. Returns null if the time is outside `last`, if the regions differ, or if `next` has
 * meshes, because there is no mesh between the joined time steps.
 */
std::shared_ptr<const BakedVolume> JoinTimeSpans(
  const BakedVolume& last, const BakedVolume& next, double time);

} // namespace VolumeHaptics

#endif
