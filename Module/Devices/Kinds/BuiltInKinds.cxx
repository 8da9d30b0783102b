// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Kinds/BuiltInKinds.h"

#include "Devices/Falcon/FalconKind.h"
#include "Devices/Haply/HaplyKind.h"
#include "Devices/Hfab/HfabKind.h"
#include "Devices/Pad/PadKind.h"
#include "Devices/Pid/PidKind.h"
#include "Devices/SpaceMouse/SpaceMouseKind.h"
#include "Devices/Vendor/VendorKind.h"
#include "Devices/WoodenHaptics/WoodenKind.h"
#include "Devices/Xr/XrKind.h"

namespace VolumeHaptics
{
namespace
{

#if !defined(VOLUME_HAPTICS_HAS_LIBUSB) || !defined(VOLUME_HAPTICS_HAS_HIDAPI) || \
  !defined(VOLUME_HAPTICS_HAS_BEAST)
DeviceKind WithoutLibrary(const char* name, const std::string& library, const std::string& option)
{
  return { name, [] { return std::vector<DeviceListing>(); },
    [library, option](const std::string& id, const DeviceOptions&, std::string& error)
    {
      error = "\"" + id + "\" needs " + library +
        ", which this library was built without. Build it with -D" + option + "=ON.";
      return nullptr;
    },
    [library, option]
    {
      return "needs " + library + ", which this library was built without. Build it with -D" +
        option + "=ON.";
    } };
}
#endif

} // namespace

std::vector<DeviceKind> GetBuiltInKinds()
{
  std::vector<DeviceKind> kinds;
#if defined(VOLUME_HAPTICS_HAS_LIBUSB)
  kinds.push_back(GetFalconKind());
#else
  kinds.push_back(WithoutLibrary("falcon", "libusb", "VolumeHaptics_USE_LIBUSB"));
#endif
#if defined(VOLUME_HAPTICS_HAS_HIDAPI)
  kinds.insert(kinds.end(), { GetWoodenKind(), GetPidKind(), GetSpaceMouseKind() });
#else
  for (const char* const name : { "wooden", "pid", "spacemouse" })
  {
    kinds.push_back(WithoutLibrary(name, "hidapi", "VolumeHaptics_USE_HIDAPI"));
  }
#endif
#if defined(VOLUME_HAPTICS_HAS_BEAST)
  kinds.push_back(GetHaplyKind());
#else
  kinds.push_back(
    WithoutLibrary("haply", "Boost.Beast and nlohmann's JSON", "VolumeHaptics_USE_BEAST"));
#endif
#if defined(VOLUME_HAPTICS_HAS_EVDEV) || defined(VOLUME_HAPTICS_HAS_HIDAPI)
  kinds.push_back(GetPadKind());
#else
  kinds.push_back(WithoutLibrary("vibration", "hidapi", "VolumeHaptics_USE_HIDAPI"));
#endif
  kinds.push_back(GetXrKind());
#if defined(VOLUME_HAPTICS_HAS_TERMIOS)
  kinds.push_back(GetHfabKind());
#endif
#if defined(VOLUME_HAPTICS_HAS_DLOPEN)
  kinds.push_back(GetVendorKind());
#endif
  return kinds;
}

} // namespace VolumeHaptics
