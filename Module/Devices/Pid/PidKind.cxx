// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidKind.h"

#include "Devices/Pid/PidDriver.h"

#include <cmath>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{

std::vector<DeviceListing> ListPid()
{
  std::vector<DeviceListing> all;
  std::string objection;
  for (const HidDeviceInfo& info : ListHidDevices())
  {
    if (PidDriver::IsPid(info, objection))
    {
      char id[16];
      std::snprintf(id, sizeof(id), "pid:%04x:%04x", info.Vendor, info.ProductId);
      all.push_back(
        { id, info.GetLabel(), objection.empty() ? info.GetState() : "refused: " + objection,
          info.KeepsIdentity() ? info.MakeIdentity("pid") : std::string() });
    }
  }
  return all;
}

std::unique_ptr<DeviceBackend> MakePid(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  PidDriver::Numbers numbers;
  if (!PidDriver::ReadNumbers(id, numbers))
  {
    error = "\"" + id +
      "\" is not a device id: give \"pid\", or \"pid:VVVV:PPPP\" with the device's vendor and "
      "product "
      "in four hexadecimal digits each.";
    return nullptr;
  }
  for (const double newtons : options.NewtonsPerFullScale)
  {
    if (!std::isfinite(newtons))
    {
      error = "NewtonsPerFullScale has to be finite: the force in N at the stick's full scale.";
      return nullptr;
    }
  }
  return std::make_unique<HardwareDevice>(
    std::make_unique<PidDriver>(numbers, options.NewtonsPerFullScale));
}

} // namespace

DeviceKind GetPidKind()
{
  return { "pid", &ListPid, &MakePid };
}

} // namespace VolumeHaptics
