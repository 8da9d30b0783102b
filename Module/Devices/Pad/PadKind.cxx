// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/PadKind.h"

#include "Devices/Common/DeviceRegistry.h"
#include "Devices/Pad/EvdevPadDriver.h"

namespace VolumeHaptics
{
namespace
{

constexpr const char* PadIds = "vibration:pad";

std::vector<DeviceListing> ListPads()
{
  std::vector<DeviceListing> all;
  for (const EvdevPad& pad : FindEvdevPads())
  {
    all.push_back({ PadIds + (":" + std::to_string(all.size())),
      pad.GetLabel() + ": vibration, not force", pad.GetState() });
  }
  return all;
}

std::string WhyNoPads()
{
  return FindEvdevPads().empty()
    ? "no gamepad is plugged in, or the system has no driver for it. Plug one in, or pair it."
    : "";
}

std::unique_ptr<DeviceBackend> MakePad(
  const std::string& id, const DeviceOptions&, std::string& error)
{
  // Without a number any pad that is free and vibrates will do.
  const int number = ReadDeviceNumber(id, PadIds, error);
  return number < 0 ? nullptr
                    : std::make_unique<HardwareDevice>(
                        std::make_unique<EvdevPadDriver>(id == PadIds ? -1 : number));
}

} // namespace

DeviceKind GetPadKind()
{
  return { "vibration", &ListPads, &MakePad, &WhyNoPads };
}

} // namespace VolumeHaptics
