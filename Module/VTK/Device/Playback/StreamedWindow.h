// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Windows of a volume whose frames come one by one, joined so that the volume does not jump.
 */
#ifndef StreamedWindow_h
#define StreamedWindow_h

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
 * Identifies the source of a filter's time steps. While it is unchanged, samples that were read
 * can be kept: only settings have changed.
 */
struct FrameOrigin
{
  const void* Connection = nullptr; ///< connection to the source; not dereferenced
  vtkMTimeType Time = 0;            ///< last change of the source, or of what it reads
  std::string Displacements;        ///< name of the displacements' array

  bool operator==(const FrameOrigin& other) const
  {
    return this->Connection == other.Connection && this->Time == other.Time &&
      this->Displacements == other.Displacements;
  }
};

inline FrameOrigin FindOrigin(vtkVolumeHapticsFilter* filter)
{
  return { filter->GetInputConnection(0, 0), FindPipelineTime(filter->GetInputAlgorithm(0, 0)),
    filter->GetDisplacementArrayName() };
}

/**
 * Earlier windows of a volume that moves. While the servo uses one of them, the frames that were
 * released with it are still in memory.
 */
class PastWindows
{
public:
  void Note(const std::shared_ptr<const BakedVolume>& window);
  /** Whether no earlier window is in use any more, or a reader of states holds one for too long. */
  bool AreGone() const;

private:
  std::vector<std::weak_ptr<const BakedVolume>> Windows;
  std::int64_t Since = 0; ///< time when the last window was added (ns)
};

/** Returns a frame of a window for use in another window. */
VolumeFrame KeepFrame(const BakedVolume& window, std::size_t number);

/**
 * Whether frames at the times `next` give the same volume at a time as frames at the times `last`.
 * The frames that both contain are equal, so this holds at a common frame, or between two
 * neighbours that both contain. Times are ascending.
 */
bool GoesOnWith(const std::vector<double>& last, const std::vector<double>& next, double time);

/**
 * Joins the frames of `next` to the two frames of `last` around a time, if `next` does not continue
 * `last` there: so the volume moves from its present shape to the next frames, whatever was left
 * out. All windows are whole series of one volume, with the first frame repeated at their ends.
 * Null if the windows are of different regions or have meshes, which would have to be made.
 */
std::shared_ptr<const BakedVolume> JoinWindows(
  const BakedVolume& last, const BakedVolume& next, double time);

} // namespace VolumeHaptics

#endif
