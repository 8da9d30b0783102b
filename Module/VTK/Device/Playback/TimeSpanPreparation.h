// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the first time steps of a moving volume that a filter bakes.
 *
 * For SURFACE_PROXY, their meshes are made in the background if meshing takes long. TimeSteps
 * chooses the steps that the servo needs.
 */
#ifndef TimeSpanPreparation_h
#define TimeSpanPreparation_h

#include "Core/Servo/DataClock.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Device/Playback/TimeStepMesher.h"

#include "vtkType.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

struct TimeSteps
{
  std::vector<double> Times; ///< ascending
  bool AreComponents = false;
  bool AreInMemory = false; ///< whether the source has all time steps in memory

  /**
   * The two neighbouring steps, First and First + 1, around the present time, and the step that is
   * needed next.
   */
  struct Need
  {
    std::size_t First;
    std::size_t Next;
  };
  /** Returns the steps that are needed when playback continues from a data time. */
  Need ComputeNeed(double time, bool isBackward, Playback mode) const;

  std::size_t After(std::size_t step) const { return (step + 1) % this->Times.size(); }
  std::size_t Before(std::size_t step) const
  {
    return (step + this->Times.size() - 1) % this->Times.size();
  }
  /** Returns whether the servo gets the whole series as one time span. */
  bool AreAllAtOnce() const
  {
    constexpr std::size_t most = 3;
    return this->AreComponents || this->AreInMemory || this->Times.size() <= most;
  }
};

struct BakedVolume;

/** Time steps that were read, and where they are in the series. */
struct PreparedTimeSpan
{
  bool AreRead = false; ///< false after an error, which the filter has reported
  TimeSteps Steps;
  std::size_t First = 0;             ///< index of the first step in Images
  std::vector<ImageTimeStep> Images; ///< empty if the volume does not move
};

/** A data time at which time steps are needed, and how playback continues from it. */
struct TimeStepPlace
{
  std::optional<double> Time; ///< data time; empty for the first step
  bool IsBackward;
  Playback Mode;
};

/** Reads the time steps of a time span and makes their meshes. Call it from the owner's thread. */
class TimeSpanPreparation
{
public:
  /**
   * Prepares the time steps; call this often. Returns whether Drain() would be quick now; if not, a
   * worker is still meshing.
   * @param last the volume that these time steps continue; null if they begin a new volume
   * @param kept an earlier time span of the same source; may be null. Its time steps are not copied
   *   again.
   */
  bool Poll(vtkVolumeHapticsFilter* filter, const TimeStepPlace& place, const BakedVolume* last,
    const BakedVolume* kept);
  /** Returns whether Poll() has read time steps that Drain() has not returned yet. */
  bool IsBegun() const { return this->Span.has_value(); }
  /** Returns whether neither this object nor its worker has time steps in memory. */
  bool IsIdle() { return !this->IsBegun() && this->Mesher.IsIdle(); }
  /**
   * Returns the data times of all steps of the prepared series; empty before Poll() has read it.
   */
  std::vector<double> GetTimes() const
  {
    return this->IsBegun() ? this->Span->Steps.Times : std::vector<double>();
  }
  /** Estimates the time (s) that the missing meshes will take. */
  double GetTimeOfRest() const { return this->IsBegun() ? this->TimeOfRest : 0.0; }

  /** Returns the time steps that Poll() has prepared. Reads them now if there are none. */
  PreparedTimeSpan Drain(
    vtkVolumeHapticsFilter* filter, const TimeStepPlace& place, const BakedVolume* kept);
  /** Returns whether the source already had further time steps at the last Drain(). */
  bool WasBehind() const { return this->TookLate; }
  /** Stops the preparation without waiting for the worker, and discards the time steps. */
  void End();

private:
  /** Modification times of the filter, with and without its image. */
  struct ChangeTimes
  {
    vtkMTimeType All;
    vtkMTimeType BesideImage;
  };
  static ChangeTimes ComputeChangeTimes(vtkVolumeHapticsFilter* filter);

  bool IsOf(vtkVolumeHapticsFilter* filter, const TimeStepPlace& place) const;
  bool Shape(vtkVolumeHapticsFilter* filter, const BakedVolume* last);

  /** Filter from which Span was read. Compare it only, because the filter may be deleted. */
  const vtkVolumeHapticsFilter* Of = nullptr;
  ChangeTimes Times{ 0, 0 };
  std::optional<PreparedTimeSpan> Span;
  double TimeOfRest = 0.0;
  bool TookLate = false;
  std::vector<VolumeTimeStep> Shaped; ///< time steps that the worker meshes
  std::vector<int> Components;        ///< components of the time steps' arrays
  double Value = 0.0;                 ///< value of the isosurface
  Affine3 IndexToWorld;
  TimeStepMesher Mesher;
};

} // namespace VolumeHaptics

#endif
