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
#include "VTK/Device/Playback/RegionMesher.h"
#include "VTK/Device/Playback/TimeStepMesher.h"

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
  /** Sets the filter; false if it is unchanged. */
  bool SetFilter(vtkVolumeHapticsFilter* filter);
  bool SetDeviceToWorld(vtkMatrix4x4* matrix);
  ///@}
  vtkVolumeHapticsFilter* GetFilter() const { return this->Filter; }
  vtkMatrix4x4* GetDeviceToWorld() const { return this->DeviceToWorld; }

  /**
   * Makes a model of the filter for a rate (Hz); null without a filter. False, after an error of
   * the filter, if the filter can't be touched. If the servo runs, meshing that Prepare() left to
   * Make() counts as long work.
   */
  bool Make(double rate, std::shared_ptr<const HapticModel>& model);
  /**
   * Returns null if Make would be quick now. If not, prepares the slow parts in the background: the
   * servo keeps its model, and Make has to be called later. The text names the work for the status.
   * @param rate rate of the model, as for Make
   */
  const char* Prepare(double rate);
  /**
   * Makes a model for a rate (Hz) of the surface around the tip, while Prepare() leaves the whole
   * mesh to the background. Null if there is no new part of the surface.
   */
  std::shared_ptr<const HapticModel> MakeRegion(double rate);
  /** Ends the work that Prepare() began. */
  void EndPreparing();
  /** Whether the last Prepare() left something to the background. */
  bool IsAwaited() const { return this->Awaited != nullptr; }

  /** Whether Make was called, successfully or not, since the filter or its input last changed. */
  bool IsUpToDate() const;

  /**
   * Passes the latest tip to the source of a volume that is read region by region. Returns whether
   * the source has a new region, which makes the model out of date. `status` says what the source
   * waits for.
   */
  bool PollRegion(std::string& status);

  ///@{
  /**
   * Play the time steps of a volume that moves. PollTimeSteps returns a model with the next time
   * span, if there is one; LacksTimeSteps says whether the volume should move but the last model
   * does not.
   */
  DataPlayback& GetPlayback() { return this->Playback; }
  std::shared_ptr<const HapticModel> PollTimeSteps();
  bool LacksTimeSteps() const;
  /** Whether the last model was made of a stream's time steps while newer time steps had come. */
  bool IsBehind() const { return this->IsMadeOfTimeSteps && this->Playback.IsBehind(); }
  /** Whether the servo's model has time steps of a volume that moves. */
  bool HasTimeSteps() const;
  /**
   * Return the image and the time of the time step nearest to the servo's time; null without a time
   * step.
   */
  vtkImageData* GetTimeStepImage();
  double GetTimeStepValue() const { return this->Playback.GetShown(this->Filter).Time; }
  ///@}

  ///@{
  /**
   * Release the removals that Make() held: all of them when the servo has ended, otherwise the
   * unused removals.
   */
  void LetRemovalsGo();
  void LetUnusedRemovalsGo();
  ///@}

  /** Returns the felt method's name for users: see vtkHapticDevice::GetMethodText. */
  std::string GetMethodText() const;

  /** DeviceToWorld of the servo's model; without a model, DeviceToWorld of the settings. */
  Affine3 GetPlacement() const;

private:
  /**
   * Reserves for this device what a model changes. False, after an error, if another device holds
   * it.
   */
  bool HoldRemovalOf(const HapticModel& model, vtkVolumeHapticsFilter* filter);
  /** Reports to the source of regions how long it took to make a model of its last region. */
  void ReportRegionMade();

  vtkHapticDevice* const Device;
  const DeviceSession& Session;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkMatrix4x4> DeviceToWorld;
  const char* Awaited = nullptr;
  RegionMesher Regions;
  /** Removals of the servo's models so far: an older model may still tick. */
  std::vector<vtkSmartPointer<vtkHapticRemoval>> Held;
  DataPlayback Playback;
  TimeStepImage Shown;
  std::int64_t RegionTime = 0;    ///< time when the region came that has no model yet (ServoClock)
  bool IsMadeOfTimeSteps = false; ///< whether the last Make was of a volume that moves
  vtkMTimeType MadeTime = 0;      ///< change time of the filter and its input when Make was called
};

} // namespace VolumeHaptics

#endif
