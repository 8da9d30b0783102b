// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Wheel/WheelKind.h"

#include "Devices/Common/DeviceTexts.h"
#include "Devices/Wheel/WheelDriver.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

std::vector<DeviceListing> ListWheelDevices()
{
  std::vector<DeviceListing> all;
  for (const EvdevNode& node : ListWheels())
  {
    all.push_back({ "wheel:" + std::to_string(all.size()), WheelDriver::MakeLabel(node),
      node.GetState(), node.Serial.empty() ? std::string() : WheelDriver::MakeIdentity(node) });
  }
  return all;
}

std::unique_ptr<DeviceBackend> MakeWheel(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  const int number = ReadDeviceNumber(id, "wheel", error);
  const double newtons = options.NewtonsPerFullScale[0];
  if (number >= 0 && (!std::isfinite(newtons) || newtons == 0.0))
  {
    error = "NewtonsPerFullScale has to be finite and not 0: the force in N at the wheel's full "
            "scale.";
    return nullptr;
  }
  return number < 0
    ? nullptr
    : std::make_unique<HardwareDevice>(std::make_unique<WheelDriver>(number, newtons));
}

} // namespace

DeviceKind GetWheelKind()
{
  return { "wheel", &ListWheelDevices, &MakeWheel };
}

} // namespace VolumeHaptics
