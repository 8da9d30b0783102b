// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/VibrationDevice.h"

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Pad/PadLimits.h"

namespace VolumeHaptics
{

VibrationDevice::VibrationDevice(std::unique_ptr<DeviceBackend> shower)
  : Shower(std::move(shower))
{
  // The mouse moves the tip, so the device has the workspace of the virtual device.
  DeviceLimits limits = MakePadLimits();
  limits.WorkspaceRadius = this->GetLimits().WorkspaceRadius;
  this->SetLimits(limits);
}

bool VibrationDevice::Open(std::string& error)
{
  this->Silence = 0.0;
  return VirtualDevice::Open(error) && this->Shower->Open(error);
}

void VibrationDevice::Close()
{
  this->Shower->Close();
  VirtualDevice::Close();
}

DeviceState VibrationDevice::Read(double period, DeviceSample& sample) noexcept
{
  const DeviceState state = this->Shower->Read(period, this->Shown);
  const bool isAlive = this->Shown.Fresh || this->Shown.Alive;
  this->Silence = isAlive ? 0.0 : this->Silence + period;
  if (state != DeviceState::Running)
  {
    return state;
  }
  const DeviceState led = VirtualDevice::Read(period, sample);
  sample.Begins = sample.Begins || this->Shown.Begins;
  if (this->Silence > HardwareExchange::WatchdogTime)
  {
    sample.Fresh = sample.Alive = false;
  }
  return led;
}

DeviceState VibrationDevice::Write(const Vector3& force) noexcept
{
  VirtualDevice::Write(force);
  return this->Shower->Write(force);
}

void VibrationDevice::Quench() noexcept
{
  this->Shower->Quench();
  VirtualDevice::Quench();
}

} // namespace VolumeHaptics
