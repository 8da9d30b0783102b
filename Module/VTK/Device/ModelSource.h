// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the servo's models of a device's filter and placement.
 */
#ifndef ModelSource_h
#define ModelSource_h

#include "VTK/Device/DataPlayback.h"
#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/Playback/FrameImage.h"
#include "VTK/Device/Playback/RegionMesher.h"

#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkHapticDevice;
class vtkHapticRemoval;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class ModelSource
{
public:
  ModelSource(vtkHapticDevice* device, const DeviceSession& session);
  ~ModelSource();

  ///@{
  /** False if it is the same as before. */
  bool SetFilter(vtkVolumeHapticsFilter* filter);
  bool SetDeviceToWorld(vtkMatrix4x4* matrix);
  ///@}
  vtkVolumeHapticsFilter* GetFilter() const { return this->Filter; }
  vtkMatrix4x4* GetDeviceToWorld() const { return this->DeviceToWorld; }

  /**
   * Makes a model of the filter for a rate (Hz); null without a filter. False, after an error of
   * the filter, if it can't be touched. If the servo runs, meshing what Prepare() leaves is
   * long work.
   */
  bool Make(double rate, std::shared_ptr<const HapticModel>& model);
  /**
   * Null if Make can be called without waiting long. If not, what takes long is being made in the
   * background: the servo goes on with its model, and Make has to be called later. The text names
   * the work, for the status.
   * @param rate of the model, as for Make
   */
  const char* Prepare(double rate);
  /**
   * While Prepare() leaves a mesh to the background: a model for a rate (Hz) of the surface around
   * the tip, once there is another one. Null if not.
   */
  std::shared_ptr<const HapticModel> MakeRegion(double rate);
  /** Ends what Prepare() began. */
  void EndPreparing();
  /** Whether the last Prepare() left something to the background. */
  bool IsAwaited() const { return this->Awaited != nullptr; }

  /** Whether Make was called, successfully or not, since the filter or its input last changed. */
  bool IsUpToDate() const;

  /**
   * If the volume is read region by region, has its source follow the latest tip. Returns whether
   * it has another region: then the model is out of date. `status` tells what the source waits for.
   */
  bool FollowRegion(std::string& status);

  ///@{
  /**
   * Time steps of a volume that moves. FollowFrames returns a model with the next window, if there
   * is one; LacksFrames tells whether the volume is to move and the last model does not.
   */
  DataPlayback& GetPlayback() { return this->Playback; }
  std::shared_ptr<const HapticModel> FollowFrames();
  bool LacksFrames() const;
  /** Whether the last model was made of frames of a stream that had gone on meanwhile. */
  bool IsBehind() const { return this->IsMadeOfFrames && this->Playback.IsBehind(); }
  /** Whether the servo's model has frames of a volume that moves. */
  bool HasFrames() const;
  /** The image and the time of the frame that is nearest to the servo's time; null without one. */
  vtkImageData* GetFrameImage();
  double GetFrameTime() const { return this->Playback.GetShown(this->Filter).Time; }
  ///@}

  ///@{
  /** Lets go of what Make() held: of all when the servo has ended, or of what it no longer uses. */
  void LetRemovalsGo();
  void LetUnusedRemovalsGo();
  ///@}

  /** See vtkHapticDevice::GetMethodText. */
  std::string GetMethodText() const;

  /** DeviceToWorld of the servo's model; without a model, by the settings. */
  Affine3 GetPlacement() const;

private:
  /** Takes what a model changes for this device. False, after an error, if another has it. */
  bool HoldRemovalOf(const HapticModel& model, vtkVolumeHapticsFilter* filter);
  /** Tells the source of regions how long it took to make a model of its last one. */
  void NoteRegionMade();

  vtkHapticDevice* const Device;
  const DeviceSession& Session;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkMatrix4x4> DeviceToWorld;
  const char* Awaited = nullptr;
  RegionMesher Regions;
  /** That the servo's models have had: an older model may still tick. */
  std::vector<vtkSmartPointer<vtkHapticRemoval>> Held;
  DataPlayback Playback;
  FrameImage Shown;
  std::int64_t RegionTime = 0; ///< ServoClock; when the region came that no model is made of yet
  bool IsMadeOfFrames = false; ///< the last Make was of a volume that moves
  vtkMTimeType MadeTime = 0;   ///< change time of the filter and its input when Make was called
};

} // namespace VolumeHaptics

#endif
