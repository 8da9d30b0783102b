// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The first frames of a volume that moves, which a filter bakes.
 *
 * For SURFACE_PROXY, their meshes are made in the background if they take long.
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
  bool AreRead = false; ///< false after an error, which the filter has told
  TimeSteps Steps;
  std::size_t First = 0;           ///< step of the first frame
  std::vector<HapticFrame> Frames; ///< none if the volume does not move
};

/** Where frames are wanted. */
struct FramePlace
{
  std::optional<double> Time; ///< data time; none: that of the first step
  bool IsBackward;
  Playback Mode;
};

/** For the owner's thread. */
class WindowPreparation
{
public:
  /**
   * To be called often: whether Take() has all that takes long. If not, that is being made.
   * @param last the volume whose further frames these are; null if they are those of a new one
   * @param kept a window that has been made of the same source; may be null. Its frames are not
   *   copied again.
   */
  bool Follow(vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* last,
    const BakedVolume* kept);
  /** Whether Follow() has read frames that Take() has not taken. */
  bool IsBegun() const { return this->Window.has_value(); }
  /** Whether neither this nor its worker has frames. */
  bool IsIdle() { return !this->IsBegun() && this->Mesher.IsIdle(); }
  /** The data times of the steps whose frames it has read; none before that. */
  std::vector<double> GetTimes() const
  {
    return this->IsBegun() ? this->Window->Steps.Times : std::vector<double>();
  }
  /** How long it takes to make what the frames lack, approximately (s). */
  double GetTimeOfRest() const { return this->IsBegun() ? this->TimeOfRest : 0.0; }

  /** The frames of Follow(); without that, they are read now. */
  ReadFrames Take(vtkVolumeHapticsFilter* filter, const FramePlace& place, const BakedVolume* kept);
  /** Whether the source had further frames when they were taken. */
  bool WasBehind() const { return this->TookLate; }
  /** Ends the preparation, without waiting for the worker, and forgets the frames. */
  void End();

private:
  /** The times of the filter's last changes: of all, and without those of the image. */
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
  std::vector<VolumeFrame> Shaped; ///< those that the worker meshes
  std::vector<int> Components;     ///< of their arrays
  double Value = 0.0;              ///< of the isosurface
  Affine3 IndexToWorld;
  FrameMesher Mesher;
};

} // namespace VolumeHaptics

#endif
