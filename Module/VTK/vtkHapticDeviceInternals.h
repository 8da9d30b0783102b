// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The private side of vtkHapticDevice.
 */
#ifndef vtkHapticDeviceInternals_h
#define vtkHapticDeviceInternals_h

#include "vtkHapticDevice.h"

#include "VTK/Baking/HapticBaker.h"
#include "VTK/Baking/HapticVolumeView.h"
#include "VTK/Session/HapticChangeTime.h"
#include "VTK/Session/HapticDeviceHolder.h"
#include "VTK/Session/HapticLongWork.h"

#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <set>

struct vtkHapticDevice::vtkInternals
{
  VolumeHaptics::HapticDeviceHolder Holder;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkMatrix4x4> DeviceToWorld;
  std::string RecordingFile;
  std::set<int> Readers;     // of AddReader
  bool IsAnnouncing = false; // while observers are told that it was disarmed
  bool IsRecordingTroubleTold = false;

  vtkMTimeType PublishedTime = 0; // of the changes that were published last, or could not be

  /** Whether there is a recording that this process has to end. */
  bool IsRecording() const
  {
    const VolumeHaptics::HapticSession* const session = this->Holder.GetSession();
    return session && session->IsRecording() && session->IsOurs();
  }

  /** A snapshot of the filter for a rate (Hz); null without a filter. False after an error. */
  bool Bake(
    vtkHapticDevice* self, double rate, std::shared_ptr<const VolumeHaptics::HapticModel>& model)
  {
    // Observers of the work may give the device another one.
    const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->Filter;
    if (filter)
    {
      const VolumeHaptics::LongWork work(self, "the surface is meshed",
        self->IsRunning() ? VolumeHaptics::HapticBaker(filter).EstimateTime() : 0.0);
      const auto caps = VolumeHaptics::CapsOf(this->Holder.GetLimits(), 1.0 / rate);
      model = VolumeHaptics::HapticBaker(filter).Bake(rate, caps, this->DeviceToWorld);
      this->PublishedTime = VolumeHaptics::FindChangeTime(filter);
    }
    return !filter || model;
  }

  /** Where the device is: as published, or as far as that can be said without a model. */
  VolumeHaptics::Affine3 GetPlacement()
  {
    const VolumeHaptics::HapticSession* const session = this->Holder.GetSession();
    if (session && session->GetLatestModel())
    {
      return session->GetLatestModel()->DeviceToWorld;
    }
    VolumeHaptics::Affine3 map;
    std::string error;
    if (!this->DeviceToWorld || !ReadSimilarity(this->DeviceToWorld, map, error))
    {
      const double meters = this->Filter ? this->Filter->GetMetersPerWorldUnit() : 1e-3;
      map = {};
      map.Linear = (1.0 / meters) * VolumeHaptics::Matrix3{};
    }
    return map;
  }

  VolumeHaptics::SafetyLimits MakeLimits(vtkHapticDevice* self)
  {
    VolumeHaptics::SafetyLimits limits;
    limits.MaximumForce = self->GetMaximumForce();
    limits.MaximumForceRate = self->GetMaximumForceRate();
    limits.AttentionTime = self->GetAttentionTime();
    limits.MaximumSpeed = this->Holder.GetLimits().MaximumSpeed;
    return limits;
  }
};

#endif
