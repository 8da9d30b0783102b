// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/BuiltInKinds.h"

namespace VolumeHaptics
{
namespace
{

#if !defined(VOLUME_HAPTICS_HAS_LIBUSB) || !defined(VOLUME_HAPTICS_HAS_HIDAPI)
DeviceKind WithoutLibrary(const char* name, const std::string& library, const std::string& option)
{
  return { name, [] { return std::vector<DeviceListing>(); },
    [library, option](const std::string& id, const DeviceOptions&, std::string& error)
    {
      error = "\"" + id + "\" needs " + library +
        ", which this library was built without. Build it with -D" + option + "=ON.";
      return nullptr;
    } };
}
#endif

} // namespace

#if !defined(VOLUME_HAPTICS_HAS_LIBUSB)
DeviceKind GetFalconKind()
{
  return WithoutLibrary("falcon", "libusb", "VolumeHaptics_USE_LIBUSB");
}
#endif

#if !defined(VOLUME_HAPTICS_HAS_HIDAPI)
DeviceKind GetWoodenKind()
{
  return WithoutLibrary("wooden", "hidapi", "VolumeHaptics_USE_HIDAPI");
}

DeviceKind GetPidKind()
{
  return WithoutLibrary("pid", "hidapi", "VolumeHaptics_USE_HIDAPI");
}

DeviceKind GetSpaceMouseKind()
{
  return WithoutLibrary("spacemouse", "hidapi", "VolumeHaptics_USE_HIDAPI");
}
#endif

std::vector<DeviceKind> GetBuiltInKinds()
{
  return { GetFalconKind(), GetWoodenKind(), GetPidKind(), GetSpaceMouseKind() };
}

} // namespace VolumeHaptics
