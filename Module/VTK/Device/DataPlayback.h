// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plays the frames of a volume that moves to the servo: time steps of a filter's image, or
 * components of it.
 *
 * The servo has a window of two or three time steps (FrameSeries.h), and its clock goes through
 * them (DataClock.h). Here, on the owner's thread, the next step is read ahead of the servo's time,
 * and a new window is published, with the tables of the last one. Three steps are in memory at
 * most, beside the one that their source writes to: one that is no longer needed is given up first,
 * and if only settings have changed, the next model has the frames of the last one.
 * Where SetTime goes to two other steps, the servo feels the old pair until one of them is there,
 * and that one alone until it has the other one. A series of up to three steps is published whole;
 * and so are components, and the frames of a vtkHapticFrameSource, which are in memory anyway.
 *
 * For SURFACE_PROXY, a window is published when its meshes have been made, in the background; the
 * first one, too, unless they are small.
 *
 * The steps of a vtkHapticFrameSource that is streamed are whole series, too, each of which goes on
 * where the last one was: it waits until time has come to the end of that, or to a frame of both.
 * If frames were left out, the last one is joined to the next ones (StreamedWindow.h).
 */
#ifndef DataPlayback_h
#define DataPlayback_h

#include "Core/Model/HapticModel.h"
#include "Core/Servo/DataClock.h"
#include "VTK/Baking/HapticFrames.h"
#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/Playback/FrameMesher.h"
#include "VTK/Device/Playback/FrameOrigin.h"
#include "VTK/Device/Playback/PastWindows.h"
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
  /** The orders: see vtkHapticDevice. The first Play or SetTime begins the motion. */
  void SetPlays(bool on);
  void SetMode(Playback mode);
  void SetTime(double time);
  void SetSpeed(double factor) { this->Speed = factor; }
  double GetSpeed() const { return this->Speed; }
  bool IsPlaying() const { return this->Orders.Plays; }
  Playback GetMode() const { return this->Orders.Mode; }
  ///@}

  /** The data time of the latest state; that of SetTime until it is there. */
  double GetTime() const;
  /** Whether time holds since frames have not come. */
  bool IsWaiting() const;
  /** The frames that it waits for, as a sentence; empty if for none. */
  std::string Describe() const;

  /** The frame that is nearest to the servo's time; without an image. No array: there is none. */
  HapticFrame GetShown(vtkVolumeHapticsFilter* filter) const;

  /** Whether the frames of a filter's image are to be felt, if it has any. */
  bool IsFelt(vtkVolumeHapticsFilter* filter) const;
  /** The same, after asking the source of the image for its time steps. */
  bool FindFelt(vtkVolumeHapticsFilter* filter) const;
  ///@{
  /**
   * Whether Make() would be quick now. If not, what takes long is being made in the background, and
   * the servo goes on within the window that it has. To be called often until EndPreparing().
   */
  bool Prepare(vtkVolumeHapticsFilter* filter, double rate, bool isCurrent);
  void EndPreparing() { this->Preparation.End(); }
  /** How long Make() meshes if Prepare() leaves that to it, approximately (s). */
  double EstimateTime() const { return this->Preparation.GetTimeOfRest(); }
  ///@}
  /** Whether the source of a stream had further frames when Make() was called. */
  bool IsBehind() const { return this->Preparation.WasBehind(); }
  /**
   * A model of the window at the time; null after an error of the filter. If neither the filter nor
   * the volume has changed (`isCurrent`), nothing is read or baked again.
   */
  std::shared_ptr<const HapticModel> Make(vtkVolumeHapticsFilter* filter, double rate,
    const ForceCaps& caps, vtkMatrix4x4* deviceToWorld, bool isCurrent);
  /** The servo's model is no longer one of the last window. */
  void Forget() { this->Window.reset(); }

  /** Has a servo that has just been started go on at the time of the last one. */
  void Begin();
  /**
   * To be called often: tells the servo the filter's rate, and follows its time. A model with the
   * next window, if there is one.
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
  bool IsMoving = false; ///< Play or SetTime was called
  bool HasTime = false;  ///< Time is that of the servo
  double Time = 0.0;
  double Speed = 1.0; ///< times the filter's rate
  TimeSteps Steps;
  std::shared_ptr<const BakedVolume> Window;
  std::size_t First = 0; ///< step of the window's first frame
  double Rate = 0.0;     ///< Hz, for which the window was baked
  /** When the filter, without its image, had changed before the window was baked. */
  vtkMTimeType MadeBeside = 0;
  FrameOrigin MadeOf; ///< the window
  PastWindows Past;
  std::size_t Failed = None; ///< a step that can't be read
  /** A window that waits for its meshes. */
  std::vector<VolumeFrame> Meshless;
  std::size_t MeshlessFirst = 0; ///< step of its first frame
  FrameMesher Mesher;
  WindowPreparation Preparation;
};

} // namespace VolumeHaptics

#endif
