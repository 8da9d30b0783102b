// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the models that the servo uses, from a device's filter and its placement in the world.
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
class vtkHapticRegionSource;
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
  /** Sets the filter. Returns whether it differs from the previous one. */
  bool SetFilter(vtkVolumeHapticsFilter* filter);
  bool SetDeviceToWorld(vtkMatrix4x4* matrix);
  ///@}
  vtkVolumeHapticsFilter* GetFilter() const { return this->Filter; }
  vtkMatrix4x4* GetDeviceToWorld() const { return this->DeviceToWorld; }

  /**
   * Makes a model of the filter for a rate (Hz) and stores it in `model`; null without a filter.
   * Returns false, after an error of the filter, if the filter's input can't be touched. While the
   * servo runs, meshing that Prepare() did not finish is announced as long work.
   */
  bool Make(double rate, std::shared_ptr<const HapticModel>& model);
  /**
   * Returns null if Make would be quick now. Otherwise computes the slow parts in the background,
   * and returns the name of that work for the status. The servo keeps its model until Make is
   * called.
   * @param rate rate of the model, as for Make
   */
  const char* Prepare(double rate);
  /**
   * Makes a model of the surface around the tip, for a rate (Hz), while Prepare() makes the whole
   * mesh in the background. Returns null if no new part of the surface is ready.
   */
  std::shared_ptr<const HapticModel> MakeRegion(double rate);
  /** Stops the background work of Prepare(). */
  void EndPreparing();
  /** Returns whether the last Prepare() started background work. */
  bool IsAwaited() const { return this->Awaited != nullptr; }

  /**
   * Returns whether Make was called, successfully or not, since the filter or its input last
   * changed.
   */
  bool IsUpToDate() const;
  /** Makes IsUpToDate() return false until the next Make(). */
  void Outdate() { this->MadeTime = 0; }

  /**
   * Reports the latest tip position to the source of a volume that is read region by region.
   * Returns whether the source has a new region, which makes the model out of date. Sets `status`
   * to a text about what the source waits for.
   */
  bool PollRegion(std::string& status);
  /**
   * Makes the source read its regions around this device's tip, unless it already follows another
   * tip.
   */
  void TakeLead();

  ///@{
  /**
   * Plays the time steps of a moving volume. PollTimeSteps returns a model of the next time span,
   * if there is one. LacksTimeSteps returns whether the volume should move although the last model
   * does not.
   */
  DataPlayback& GetPlayback() { return this->Playback; }
  std::shared_ptr<const HapticModel> PollTimeSteps();
  bool LacksTimeSteps() const;
  /**
   * Returns whether a stream already had newer time steps when the last model was made from its
   * time steps.
   */
  bool IsBehind() const { return this->IsMadeOfTimeSteps && this->Playback.IsBehind(); }
  /** Returns whether the servo's model has time steps of a moving volume. */
  bool HasTimeSteps() const;
  /**
   * Return the image and the time of the time step nearest to the servo's time. The image is null
   * if there is no time step.
   */
  vtkImageData* GetTimeStepImage();
  double GetTimeStepValue() const { return this->Playback.GetShown(this->Filter).Time; }
  ///@}

  ///@{
  /**
   * Release the removals that Make() reserved: all of them when the servo has ended, otherwise only
   * the unused ones. When the servo has ended, the source of regions may also follow another tip.
   */
  void LetRemovalsGo();
  void LetUnusedRemovalsGo();
  ///@}

  /** Returns the name of the felt method for users: see vtkHapticDevice::GetMethodText. */
  std::string GetMethodText() const;

  /** Returns DeviceToWorld of the servo's model; without a model, DeviceToWorld of the settings. */
  Affine3 GetPlacement() const;

private:
  /**
   * Returns the model itself, or a copy that touches with a point if another device's hand holds
   * the tool.
   */
  std::shared_ptr<const HapticModel> FitToHand(
    std::shared_ptr<const HapticModel> model, const ForceCaps& caps);
  /**
   * Reserves the removal that a model changes for this device. Returns false and reports an error
   * if another device has reserved it.
   */
  bool HoldRemovalOf(const HapticModel& model, vtkVolumeHapticsFilter* filter);
  /** Returns whether a source of regions follows this device's tip; false for null. */
  bool Leads(vtkHapticRegionSource* source);
  /** Reports the time that the model of the last region took to the source of regions. */
  void ReportRegionMade();

  vtkHapticDevice* const Device;
  const DeviceSession& Session;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkMatrix4x4> DeviceToWorld;
  const char* Awaited = nullptr;
  RegionMesher Regions;
  /**
   * Removals of all models that the servo has used. They stay reserved because a tick may still use
   * an older model.
   */
  std::vector<vtkSmartPointer<vtkHapticRemoval>> Held;
  DataPlayback Playback;
  TimeStepImage Shown;
  ///@{
  /** Input and result of the last FitToHand() call that made a copy. */
  std::shared_ptr<const BakedVolume> WithTool;
  std::shared_ptr<const BakedVolume> ForPoint;
  ///@}
  vtkSmartPointer<vtkHapticRegionSource> Led; ///< source whose regions follow this device's tip
  std::int64_t RegionTime = 0;    ///< arrival time (ServoClock) of the region that has no model yet
  bool IsMadeOfTimeSteps = false; ///< whether the last model contains time steps of a moving volume
  vtkMTimeType MadeTime = 0;      ///< modification time of the filter and its input at the last
                                  ///< Make
};

} // namespace VolumeHaptics

#endif
