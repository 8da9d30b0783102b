// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Xr/XrDevice.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/PadLimits.h"

#include <algorithm>

namespace VolumeHaptics
{

XrDevice::XrDevice()
{
  // The controller is at the tip, so the device has the workspace of the virtual device.
  DeviceLimits limits = MakePadLimits();
  limits.WorkspaceRadius = this->GetLimits().WorkspaceRadius;
  this->SetLimits(limits);
}

DeviceState XrDevice::Read(double period, DeviceSample& sample) noexcept
{
  this->Elapsed += period;
  return VirtualDevice::Read(period, sample);
}

DeviceState XrDevice::Write(const Vector3& force) noexcept
{
  const VibrationLevels levels = this->Levels.Advance(force, this->Elapsed);
  this->Elapsed = 0.0;
  const double amplitude = std::max(levels.Strong, levels.Weak);
  double largest = this->Largest.load(std::memory_order_relaxed);
  // The loop repeats at most once, because only DrainAmplitude() changes Largest on another thread.
  while (amplitude > largest &&
    !this->Largest.compare_exchange_strong(largest, amplitude, std::memory_order_relaxed))
  {
  }
  this->WrittenAt.store(ServoClock::Now(), std::memory_order_relaxed);
  this->IsQuenched.store(false, std::memory_order_release);
  return VirtualDevice::Write(force);
}

void XrDevice::Quench() noexcept
{
  this->IsQuenched.store(true, std::memory_order_release);
  VirtualDevice::Quench();
}

double XrDevice::DrainAmplitude() noexcept
{
  const double largest = this->Largest.exchange(0.0, std::memory_order_relaxed);
  const bool isSilent = this->IsQuenched.load(std::memory_order_acquire) ||
    ServoClock::SecondsSince(this->WrittenAt.load(std::memory_order_relaxed)) > LongestSilence;
  return isSilent ? 0.0 : largest;
}

} // namespace VolumeHaptics
