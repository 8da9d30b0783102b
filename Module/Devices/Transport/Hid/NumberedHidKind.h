// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions for kinds of HID devices whose ids differ only by a number.
 */
#ifndef NumberedHidKind_h
#define NumberedHidKind_h

#include "Devices/Common/DeviceKind.h"
#include "Devices/Common/DeviceTexts.h"
#include "Devices/Common/HardwareDevice.h"
#include "Devices/Transport/Hid/HidPort.h"

namespace VolumeHaptics
{

/** Lists the devices of a kind, with numbered ids such as wooden:0, wooden:1. */
inline std::vector<DeviceListing> ListNumbered(
  const char* kind, bool (*isSome)(const HidDeviceInfo&), bool givesForce)
{
  std::vector<DeviceListing> all;
  for (const HidDeviceInfo& info : ListHidDevices(isSome))
  {
    all.push_back({ kind + (":" + std::to_string(all.size())), info.GetLabel(), info.GetState(),
      givesForce && info.KeepsIdentity() ? info.MakeIdentity(kind) : std::string() });
  }
  return all;
}

/**
 * Makes a kind of devices with numbered ids. Driver is a class whose constructor's argument is the
 * number of a device.
 */
template <typename Driver>
DeviceKind MakeNumberedKind(const char* kind, bool (*isSome)(const HidDeviceInfo&), bool givesForce)
{
  return { kind, [kind, isSome, givesForce] { return ListNumbered(kind, isSome, givesForce); },
    [kind](const std::string& id, const DeviceOptions&,
      std::string& error) -> std::unique_ptr<DeviceBackend>
    {
      const int number = ReadDeviceNumber(id, kind, error);
      return number < 0 ? nullptr
                        : std::make_unique<HardwareDevice>(std::make_unique<Driver>(number));
    } };
}

} // namespace VolumeHaptics

#endif
