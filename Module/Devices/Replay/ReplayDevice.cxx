// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Replay/ReplayDevice.h"

#include <utility>

namespace VolumeHaptics
{

ReplayDevice::ReplayDevice(
  std::vector<Vector3> tips, std::string name, std::vector<Quaternion> orientations)
  : Tips(std::move(tips))
  , Orientations(std::move(orientations))
  , Name(std::move(name))
{
}

bool ReplayDevice::Open(std::string& error)
{
  this->Next = 0;
  if (this->Tips.empty())
  {
    error = "The recording " + this->Name + " holds no tip positions. Record again.";
    return false;
  }
  return true;
}

DeviceLimits ReplayDevice::GetLimits() const
{
  // No hand holds the device, so only the displayed force needs a limit. A path with jumps is
  // replayed unchanged.
  DeviceLimits limits;
  limits.MaximumForce = 20.0;
  limits.MovesTip = false;
  return limits;
}

DeviceState ReplayDevice::Read(double, DeviceSample& sample) noexcept
{
  if (this->Next == this->Tips.size())
  {
    sample.Tip = this->Tips.back();
    return DeviceState::Finished;
  }
  sample.HasOrientation = this->Next < this->Orientations.size();
  if (sample.HasOrientation)
  {
    sample.Orientation = this->Orientations[this->Next];
  }
  sample.Tip = this->Tips[this->Next++];
  sample.Fresh = true;
  return DeviceState::Running;
}

DeviceState ReplayDevice::Write(const Vector3&) noexcept
{
  return this->Next == this->Tips.size() ? DeviceState::Finished : DeviceState::Running;
}

} // namespace VolumeHaptics
