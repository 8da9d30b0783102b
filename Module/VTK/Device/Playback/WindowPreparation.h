// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the first frames of a moving volume that a filter bakes.
 *
 * For SURFACE_PROXY, their meshes are made in the background if meshing takes long.
 */
#ifndef WindowPreparation_h
#define WindowPreparation_h

#include "VTK/Baking/HapticFrames.h"
#include "VTK/Device/Playback/FrameMesher.h"
#include "VTK/Device/Playback/TimeSteps.h"

#include "vtkType.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{
struct BakedVolume;

/** Frames as they were read. */
struct ReadFrames
{
  bool AreRead = false; ///< false after an error, which the filter has reported
  TimeSteps Steps;
  std::size_t First = 0;           ///< number of the first frame's step
  std::vector<HapticFrame> Frames; ///< empty if the volume does not move
};

/** The data time at which frames are wanted, and the playback there. */
struct FramePlace
{
  std::optional<double> Time; ///< data time; none stands for the first step
  bool IsBackward;
  Playback Mode;
};

/** Prepares a window. Call it from the owner's thread. */
class WindowPreparation
{
public:
  /**
   * Prepares the frames; whether Take() has all that takes long. If not, it is being made. Call
   * this often.
   * @param last the volume that these frames continue; null if they begin a new volume
   * @param kept a window that has been made of the same source; may be null. Its frames are not
   *   copied again.
   */
  bool Follow(vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* last,
    const BakedVolume* kept);
  /** Whether Follow() has read frames that Take() has not taken yet. */
  bool IsBegun() const { return this->Window.has_value(); }
  /** Whether neither this nor its worker holds frames. */
  bool IsIdle() { return !this->IsBegun() && this->Mesher.IsIdle(); }
  /** Data times of the steps whose frames have been read; empty before that. */
  std::vector<double> GetTimes() const
  {
    return this->IsBegun() ? this->Window->Steps.Times : std::vector<double>();
  }
  /** Estimates how long it takes to make what the frames still lack (s). */
  double GetTimeOfRest() const { return this->IsBegun() ? this->TimeOfRest : 0.0; }

  /** Returns the frames of Follow(); if there are none, reads them now. */
  ReadFrames Take(vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* kept);
  /** Whether the source had further frames when they were taken. */
  bool WasBehind() const { return this->TookLate; }
  /** Ends the preparation without waiting for the worker, and discards the frames. */
  void End();

private:
  /** Times of the filter's last changes: all changes, and all but the image's. */
  struct ChangeTimes
  {
    vtkMTimeType All;
    vtkMTimeType BesideImage;
  };
  static ChangeTimes FindTimes(vtkVolumeHapticsFilter* filter);

  bool IsOf(vtkVolumeHapticsFilter* filter, const FramePlace& place) const;
  bool Shape(vtkVolumeHapticsFilter* filter, const BakedVolume* last);

  const vtkVolumeHapticsFilter* Of = nullptr; ///< not dereferenced
  ChangeTimes Times{ 0, 0 };
  std::optional<ReadFrames> Window;
  double TimeOfRest = 0.0;
  bool TookLate = false;
  std::vector<VolumeFrame> Shaped; ///< frames that the worker meshes
  std::vector<int> Components;     ///< components of the frames' arrays
  double Value = 0.0;              ///< value of the isosurface
  Affine3 IndexToWorld;
  FrameMesher Mesher;
};

} // namespace VolumeHaptics

#endif
