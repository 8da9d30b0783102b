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
  /** Sets the filter. Returns false if it is unchanged. */
  bool SetFilter(vtkVolumeHapticsFilter* filter);
  bool SetDeviceToWorld(vtkMatrix4x4* matrix);
  ///@}
  vtkVolumeHapticsFilter* GetFilter() const { return this->Filter; }
  vtkMatrix4x4* GetDeviceToWorld() const { return this->DeviceToWorld; }

  /**
   * Makes a model of the filter for a rate (Hz), or null if there is no filter, and writes it to
   * `model`. Returns false, after an error of the filter, if the filter can't be touched. If the
   * servo runs, meshing that Prepare() left to Make() counts as long work.
   */
  bool Make(double rate, std::shared_ptr<const HapticModel>& model);
  /**
   * Returns null if Make would be quick now. Otherwise prepares the slow parts in the background,
   * and returns a text that names the work for the status. Until Make is called later, the servo
   * keeps its model.
   * @param rate rate of the model, as for Make
   */
  const char* Prepare(double rate);
  /**
   * Makes a model of the surface around the tip, for a rate (Hz), while Prepare() leaves the whole
   * mesh to the background. Returns null if there is no new part of the surface.
   */
  std::shared_ptr<const HapticModel> MakeRegion(double rate);
  /** Ends the work that Prepare() began. */
  void EndPreparing();
  /** Returns whether the last Prepare() left something to the background. */
  bool IsAwaited() const { return this->Awaited != nullptr; }

  /**
   * Returns whether Make was called, successfully or not, since the filter or its input last
   * changed.
   */
  bool IsUpToDate() const;
  /** Makes IsUpToDate() false until the next Make. */
  void Outdate() { this->MadeTime = 0; }

  /**
   * Sets the latest position of the tip in the source of a volume that is read region by region.
   * Returns whether the source has a new region, which makes the model out of date. Writes to
   * `status` what the source waits for.
   */
  bool PollRegion(std::string& status);
  /** Makes the regions of the filter's source follow this tip, unless they follow another one. */
  void TakeLead();

  ///@{
  /**
   * Play the time steps of a moving volume. PollTimeSteps returns a model with the next time span
   * if there is one. LacksTimeSteps returns whether the volume should move although the last model
   * does not.
   */
  DataPlayback& GetPlayback() { return this->Playback; }
  std::shared_ptr<const HapticModel> PollTimeSteps();
  bool LacksTimeSteps() const;
  /**
   * Returns whether a stream already had newer time steps when the last model was made of its time
   * steps.
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
   * Release the removals that Make() held: all of them when the servo has ended, otherwise the
   * unused removals. When the servo has ended, also release the lead of a source of regions.
   */
  void LetRemovalsGo();
  void LetUnusedRemovalsGo();
  ///@}

  /** Returns the felt method's name for users: see vtkHapticDevice::GetMethodText. */
  std::string GetMethodText() const;

  /** Returns DeviceToWorld of the servo's model, or that of the settings if there is no model. */
  Affine3 GetPlacement() const;

private:
  /**
   * Returns the model, or if the device leaves the tool to another hand, the model for a point.
   */
  std::shared_ptr<const HapticModel> FitToHand(
    std::shared_ptr<const HapticModel> model, const ForceCaps& caps);
  /**
   * Reserves for this device the removal that a model changes. Returns false and reports an error
   * if another device holds it.
   */
  bool HoldRemovalOf(const HapticModel& model, vtkVolumeHapticsFilter* filter);
  /** Returns whether the regions of a source, which may be null, follow this device's tip. */
  bool Leads(vtkHapticRegionSource* source);
  /** Reports to the source of regions how long it took to make a model of its last region. */
  void ReportRegionMade();

  vtkHapticDevice* const Device;
  const DeviceSession& Session;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkMatrix4x4> DeviceToWorld;
  const char* Awaited = nullptr;
  RegionMesher Regions;
  /**
   * Removals of all models that the servo has had. They stay reserved because an older model may
   * still tick.
   */
  std::vector<vtkSmartPointer<vtkHapticRemoval>> Held;
  DataPlayback Playback;
  TimeStepImage Shown;
  ///@{
  /** The last volume that FitToHand() has changed, and the volume that it has made. */
  std::shared_ptr<const BakedVolume> WithTool;
  std::shared_ptr<const BakedVolume> ForPoint;
  ///@}
  vtkSmartPointer<vtkHapticRegionSource> Led; ///< the source whose regions follow this tip
  std::int64_t RegionTime = 0;    ///< arrival time (ServoClock) of the region that has no model yet
  bool IsMadeOfTimeSteps = false; ///< whether the last model was made of a moving volume
  vtkMTimeType MadeTime = 0;      ///< modification time of the filter and its input at the last
                                  ///< Make
};

} // namespace VolumeHaptics

#endif
