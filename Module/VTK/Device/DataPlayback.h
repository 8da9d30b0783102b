// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plays a moving volume on the servo. Its time steps are read from the source of a filter's image,
 * or are components of this image.
 *
 * The servo gets a time span of two or three time steps (TimeStepSeries.h), and its clock moves
 * through them (DataClock.h). This class runs on the owner's thread. It reads the next step before
 * the servo's time reaches it, and publishes a new time span with the tables of the last time span.
 * At most three steps are in memory, plus the one that their source writes to: a step that is no
 * longer needed is released first, and if only settings have changed, the next model keeps the time
 * steps of the last model. If SetTime jumps to a pair of two other steps, the servo feels the old
 * pair until one new step is read, and only this step until the second one is read. A series of up
 * to three steps is published at once. So are components and the time steps of a
 * vtkHapticTimeStepSource, because they are in memory anyway.
 *
 * For SURFACE_PROXY, meshes are made in the background, and a time span is published when it has
 * its meshes. This holds for the first time span, too, unless its meshes are small.
 *
 * A streamed vtkHapticTimeStepSource provides whole series, one after the other. The next series is
 * published only when time has reached the end of the present series, or a time step that both
 * contain. If time steps were left out, the last time step is joined to the next time steps
 * (StreamedTimeSpan.h).
 */
#ifndef DataPlayback_h
#define DataPlayback_h

#include "Core/Model/HapticModel.h"
#include "Core/Servo/DataClock.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/Playback/StreamedTimeSpan.h"
#include "VTK/Device/Playback/TimeSpanPreparation.h"
#include "VTK/Device/Playback/TimeStepMesher.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkMatrix4x4;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class DataPlayback
{
public:
  explicit DataPlayback(const DeviceSession& session)
    : Session(session)
  {
  }

  ///@{
  /**
   * Carry out the playback orders of vtkHapticDevice. The first Play or SetTime starts the motion.
   */
  void SetPlays(bool on);
  void SetMode(Playback mode);
  void SetTime(double time);
  void SetSpeed(double factor) { this->Speed = factor; }
  double GetSpeed() const { return this->Speed; }
  bool IsPlaying() const { return this->Orders.Plays; }
  Playback GetMode() const { return this->Orders.Mode; }
  ///@}

  /**
   * Returns the data time of the latest state. After SetTime, returns the requested time until the
   * servo has reached it.
   */
  double GetTime() const;
  /** Returns whether time is paused until the next time steps are read. */
  bool IsWaiting() const;
  /** Returns a sentence on the time steps that playback waits for; empty if it is not waiting. */
  std::string Describe() const;

  /**
   * Returns the time step nearest to the servo's time, without its image. Its Array is null if
   * there is no time step.
   */
  ImageTimeStep GetShown(vtkVolumeHapticsFilter* filter) const;

  /** Returns whether the filter is set up so that its image's time steps are felt. */
  bool IsFelt(vtkVolumeHapticsFilter* filter) const;
  /** Checks IsFelt() after an update of the information from the image's source. */
  bool DetectFelt(vtkVolumeHapticsFilter* filter) const;
  ///@{
  /**
   * Returns whether Make() would be quick now. If not, prepares the slow parts in the background,
   * while the servo stays within its present time span. Call this often until EndPreparing().
   */
  bool Prepare(vtkVolumeHapticsFilter* filter, double rate, bool isCurrent);
  void EndPreparing() { this->Preparation.End(); }
  /** Estimates the time (s) that Make() still needs for meshes that Prepare() did not make. */
  double EstimateTime() const { return this->Preparation.GetTimeOfRest(); }
  ///@}
  /** Returns whether the source of a stream already had further time steps at the last Make(). */
  bool IsBehind() const { return this->Preparation.WasBehind(); }
  /**
   * Makes a model of the time span at the present time; null after an error of the filter. Reads
   * and bakes nothing again if neither the filter nor the volume has changed (`isCurrent`).
   */
  std::shared_ptr<const HapticModel> Make(vtkVolumeHapticsFilter* filter, double rate,
    const ForceCaps& caps, vtkMatrix4x4* deviceToWorld, bool isCurrent);
  /** Discards the last time span. Call this when the servo gets a model from another source. */
  void Forget() { this->Span.reset(); }

  /** Makes a newly started servo continue at the time of the last servo. */
  void Begin();
  /**
   * Sends the filter's rate to the servo and reads its time; call this often. Returns a model with
   * the next time span, if there is one.
   */
  std::shared_ptr<const HapticModel> Poll(vtkVolumeHapticsFilter* filter);

private:
  using Need = TimeSteps::Need;
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  TimeStepPlace ComputePlace(vtkVolumeHapticsFilter* filter) const;
  bool Has(std::size_t step) const;
  Need ComputeNeed(double time, bool isBackward) const;
  std::vector<std::size_t> ChooseSteps(const Need& need, double time) const;
  std::vector<VolumeTimeStep> Keep(std::size_t first, std::size_t count);
  bool Read(vtkVolumeHapticsFilter* filter, std::size_t step, VolumeTimeStep& timeStep);
  std::shared_ptr<const HapticModel> Show(
    std::size_t first, std::vector<VolumeTimeStep>&& timeSteps);
  bool IsStreamed(vtkVolumeHapticsFilter* filter, double rate) const;
  const BakedVolume* GetKept(vtkVolumeHapticsFilter* filter) const;
  bool LacksPair(vtkVolumeHapticsFilter* filter) const;
  void GoOnFrom(const BakedVolume& last, const std::vector<double>& times);
  std::shared_ptr<const HapticModel> ShowMeshed(
    vtkVolumeHapticsFilter* filter, std::size_t first, std::vector<VolumeTimeStep>&& timeSteps);
  void WarnOfFastMotion(vtkVolumeHapticsFilter* filter) const;
  bool IsAtPlace() const;
  bool IsOnItsWay() const;
  void Send();

  const DeviceSession& Session;
  DataClockOrders Orders;
  DataClockOrders Sent;
  bool IsMoving = false; ///< whether Play or SetTime was called
  bool HasTime = false;  ///< whether the servo has reported Time
  double Time = 0.0;
  double Speed = 1.0; ///< factor on the filter's rate
  TimeSteps Steps;
  std::shared_ptr<const BakedVolume> Span;
  std::size_t First = 0; ///< index of the time span's first step
  double Rate = 0.0;     ///< rate for which the time span was baked (Hz)
  /** Modification time of the filter, without its image, taken before the time span was baked. */
  vtkMTimeType MadeBeside = 0;
  TimeStepOrigin MadeOf; ///< source of the time span's time steps
  PastTimeSpans Past;
  std::size_t Failed = None; ///< index of a step that can't be read
  /** Time steps of a time span whose meshes are still being made. */
  std::vector<VolumeTimeStep> Meshless;
  std::size_t MeshlessFirst = 0; ///< index of that time span's first step
  TimeStepMesher Mesher;
  TimeSpanPreparation Preparation;
};

} // namespace VolumeHaptics

#endif
