// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Groups the parts that implement a vtkHapticDevice.
 */
#ifndef DeviceParts_h
#define DeviceParts_h

#include "VTK/Device/DeviceOrders.h"
#include "VTK/Device/DeviceSession.h"
#include "VTK/Device/ModelSource.h"

#include "vtkHapticPlayback.h"
#include "vtkHapticRecorder.h"
#include "vtkHapticState.h"
#include "vtkHapticVirtualHand.h"
#include "vtkNew.h"

class vtkHapticDevice;

namespace VolumeHaptics
{

/**
 * Owns the parts of a device. An application may keep the public parts longer than the device;
 * without their device, they report errors.
 */
struct DeviceParts
{
  explicit DeviceParts(vtkHapticDevice* device)
    : Device(device)
    , Models(device, Session)
    , Orders(device, Session, Models)
  {
    this->Session.GetLatest()->Parts = this;
    this->Playback->Parts = this;
    this->Hand->Parts = this;
    this->Recorder->Attach(*this);
  }
  ~DeviceParts()
  {
    this->Session.GetLatest()->Parts = nullptr;
    this->Playback->Parts = nullptr;
    this->Hand->Parts = nullptr;
    this->Recorder->Detach();
  }
  DeviceParts(const DeviceParts&) = delete;
  DeviceParts& operator=(const DeviceParts&) = delete;

  vtkHapticDevice* const Device;
  DeviceSession Session;
  ModelSource Models;
  DeviceOrders Orders;
  const vtkNew<vtkHapticPlayback> Playback;
  const vtkNew<vtkHapticRecorder> Recorder;
  const vtkNew<vtkHapticVirtualHand> Hand;
};

} // namespace VolumeHaptics

#endif
