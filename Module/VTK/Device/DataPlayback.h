// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plays the frames of a volume that moves to the servo: time steps of a filter's image, or
 * components of it.
 *
 * The servo has a window of two or three time steps (FrameSeries.h), and its clock moves through
 * them (DataClock.h). This class, on the owner's thread, reads the next step ahead of the servo's
 * time and publishes a new window with the tables of the last window. At most three steps are in
 * memory, beside the one that their source writes to: a step that is no longer needed is released
 * first, and if only settings have changed, the next model keeps the frames of the last model. If
 * SetTime jumps to a pair of two other steps, the servo feels the old pair until one new step is
 * there, and this step alone until the second one is there. A series of up to three steps is
 * published whole, as are components and the frames of a vtkHapticFrameSource, which are in memory
 * anyway.
 *
 * For SURFACE_PROXY, meshes are made in the background, and a window is published when it has its
 * meshes. This holds for the first window, too, unless its meshes are small.
 *
 * The steps of a streamed vtkHapticFrameSource are whole series, too. Each series continues the
 * last one: it waits until time has reached the end of the last series or a frame that both
 * contain. If frames were left out, the last frame is joined to the next frames (StreamedWindow.h).
 */
#ifndef DataPlayback_h
#define DataPlayback_h

#include "Core/Model/HapticModel.h"
#include "Core/Servo/DataClock.h"
#include "VTK/Baking/HapticFrames.h"
#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/Playback/FrameMesher.h"
#include "VTK/Device/Playback/StreamedWindow.h"
#include "VTK/Device/Playback/TimeSteps.h"
#include "VTK/Device/Playback/WindowPreparation.h"

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
  /** Carry out the orders of vtkHapticDevice. The first Play or SetTime begins the motion. */
  void SetPlays(bool on);
  void SetMode(Playback mode);
  void SetTime(double time);
  void SetSpeed(double factor) { this->Speed = factor; }
  double GetSpeed() const { return this->Speed; }
  bool IsPlaying() const { return this->Orders.Plays; }
  Playback GetMode() const { return this->Orders.Mode; }
  ///@}

  /**
   * Data time of the latest state; after SetTime, the time set there until the servo has reached
   * it.
   */
  double GetTime() const;
  /** Whether time stands still because frames have not come yet. */
  bool IsWaiting() const;
  /** Describes in a sentence the frames that are waited for; empty if there are none. */
  std::string Describe() const;

  /**
   * Returns the frame nearest to the servo's time, without an image. Array is null if there is
   * none.
   */
  HapticFrame GetShown(vtkVolumeHapticsFilter* filter) const;

  /** Whether the frames of a filter's image are to be felt, if it has any. */
  bool IsFelt(vtkVolumeHapticsFilter* filter) const;
  /** Checks IsFelt() after asking the image's source for its time steps. */
  bool FindFelt(vtkVolumeHapticsFilter* filter) const;
  ///@{
  /**
   * Returns whether Make() would be quick now. If not, prepares the slow parts in the background;
   * the servo stays within the window that it has. Call this often until EndPreparing().
   */
  bool Prepare(vtkVolumeHapticsFilter* filter, double rate, bool isCurrent);
  void EndPreparing() { this->Preparation.End(); }
  /** Estimates how long Make() meshes if Prepare() leaves the meshing to it (s). */
  double EstimateTime() const { return this->Preparation.GetTimeOfRest(); }
  ///@}
  /** Whether the source of a stream had further frames when Make() was called. */
  bool IsBehind() const { return this->Preparation.WasBehind(); }
  /**
   * Makes a model of the window at the present time; null after an error of the filter. If neither
   * the filter nor the volume has changed (`isCurrent`), nothing is read or baked again.
   */
  std::shared_ptr<const HapticModel> Make(vtkVolumeHapticsFilter* filter, double rate,
    const ForceCaps& caps, vtkMatrix4x4* deviceToWorld, bool isCurrent);
  /** Call this when the servo's model is no longer one of the last window. */
  void Forget() { this->Window.reset(); }

  /** Makes a servo that has just been started continue at the time of the last servo. */
  void Begin();
  /**
   * Sends the filter's rate to the servo and reads its time; call this often. Returns a model with
   * the next window, if there is one.
   */
  std::shared_ptr<const HapticModel> Follow(vtkVolumeHapticsFilter* filter);

private:
  using Need = TimeSteps::Need;
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  FramePlace FindPlace(vtkVolumeHapticsFilter* filter) const;
  bool Has(std::size_t step) const;
  Need FindNeed(double time, bool isBackward) const;
  std::vector<std::size_t> ChooseSteps(const Need& need, double time) const;
  std::vector<VolumeFrame> Keep(std::size_t first, std::size_t count);
  bool Read(vtkVolumeHapticsFilter* filter, std::size_t step, VolumeFrame& frame);
  std::shared_ptr<const HapticModel> Show(std::size_t first, std::vector<VolumeFrame>&& frames);
  bool IsStreamed(vtkVolumeHapticsFilter* filter, double rate) const;
  const BakedVolume* FindKept(vtkVolumeHapticsFilter* filter) const;
  bool LacksPair(vtkVolumeHapticsFilter* filter) const;
  void GoOnFrom(const BakedVolume& last, const std::vector<double>& times);
  std::shared_ptr<const HapticModel> ShowMeshed(
    vtkVolumeHapticsFilter* filter, std::size_t first, std::vector<VolumeFrame>&& frames);
  void WarnOfFastMotion(vtkVolumeHapticsFilter* filter) const;
  bool IsAtPlace() const;
  bool IsOnItsWay() const;
  void Send();

  const DeviceSession& Session;
  DataClockOrders Orders;
  DataClockOrders Sent;
  bool IsMoving = false; ///< whether Play or SetTime was called
  bool HasTime = false;  ///< whether Time comes from the servo
  double Time = 0.0;
  double Speed = 1.0; ///< factor on the filter's rate
  TimeSteps Steps;
  std::shared_ptr<const BakedVolume> Window;
  std::size_t First = 0; ///< number of the window's first step
  double Rate = 0.0;     ///< rate for which the window was baked (Hz)
  /** Change time of the filter, without its image, before the window was baked. */
  vtkMTimeType MadeBeside = 0;
  FrameOrigin MadeOf; ///< origin of the window's frames
  PastWindows Past;
  std::size_t Failed = None; ///< number of a step that can't be read
  /** Frames of a window that waits for its meshes. */
  std::vector<VolumeFrame> Meshless;
  std::size_t MeshlessFirst = 0; ///< number of that window's first step
  FrameMesher Mesher;
  WindowPreparation Preparation;
};

} // namespace VolumeHaptics

#endif
