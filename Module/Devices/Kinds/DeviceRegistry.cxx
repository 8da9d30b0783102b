// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Kinds/DeviceRegistry.h"

#include "Devices/Common/DeviceKind.h"
#include "Devices/Falcon/FalconKind.h"
#include "Devices/Haply/HaplyKind.h"
#include "Devices/Hfab/HfabKind.h"
#include "Devices/Pad/PadKind.h"
#include "Devices/Pid/PidKind.h"
#include "Devices/SpaceMouse/SpaceMouseKind.h"
#include "Devices/Vendor/VendorKind.h"
#if defined(VOLUME_HAPTICS_HAS_BEAST)
#include "Devices/Vibration/VibrationKinds.h"
#endif
#include "Devices/Wheel/WheelKind.h"
#include "Devices/WoodenHaptics/WoodenKind.h"
#include "Devices/Xr/XrKind.h"

#include <algorithm>
#include <mutex>

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

/**
 * Returns all built-in kinds. A kind whose library is missing from this build lists no devices, and
 * its Make returns the reason.
 */
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
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
  kinds.push_back(GetWheelKind());
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
#if defined(VOLUME_HAPTICS_HAS_BEAST)
  std::vector<DeviceKind> services = GetVibrationKinds();
  std::move(services.begin(), services.end(), std::back_inserter(kinds));
#else
  for (const char* const name : { "vibration:bhaptics", "vibration:weart", "vibration:hapbeat" })
  {
    kinds.push_back(
      WithoutLibrary(name, "Boost.Beast and nlohmann's JSON", "VolumeHaptics_USE_BEAST"));
  }
#endif
  kinds.push_back(GetXrKind());
  kinds.push_back(GetHfabKind());
  kinds.push_back(GetVendorKind());
  return kinds;
}

std::mutex Mutex;

/** Returns all kinds. Must be called with the mutex locked. */
std::vector<DeviceKind>& Kinds()
{
  static std::vector<DeviceKind> kinds = GetBuiltInKinds();
  return kinds;
}

std::vector<DeviceKind> CopyKinds()
{
  const std::lock_guard<std::mutex> lock(Mutex);
  return Kinds();
}

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

} // namespace

bool AddDeviceKind(const DeviceKind& kind, std::string& error)
{
  const std::string& name = kind.Name;
  if (name.empty() || !std::all_of(name.begin(), name.end(), IsLetter))
  {
    error = "\"" + name + "\" can't be the name of a kind of devices. Use letters only.";
    return false;
  }
  if (!kind.List || !kind.Make)
  {
    error = "The kind of devices \"" + name + "\" needs a List and a Make.";
    return false;
  }
  const std::lock_guard<std::mutex> lock(Mutex);
  std::vector<DeviceKind>& kinds = Kinds();
  const auto same = [&name](const DeviceKind& other) { return other.Name == name; };
  if (name == "virtual" || name == "replay" || std::any_of(kinds.begin(), kinds.end(), same))
  {
    error = "There are devices of the kind \"" + name + "\" already. Choose another name.";
    return false;
  }
  kinds.push_back(kind);
  return true;
}

std::vector<DeviceListing> ListDevices()
{
  std::vector<DeviceListing> all;
  for (const DeviceKind& kind : CopyKinds())
  {
    std::vector<DeviceListing> some = kind.List();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<DeviceObstacle> ListMissingKinds()
{
  std::vector<DeviceObstacle> all;
  for (const DeviceKind& kind : CopyKinds())
  {
    const std::string text = kind.Missing ? kind.Missing() : std::string();
    if (!text.empty())
    {
      all.push_back({ kind.Name, text });
    }
  }
  return all;
}

std::unique_ptr<DeviceBackend> MakeDevice(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  const std::vector<DeviceKind> kinds = CopyKinds();
  std::string known = "\"virtual\", \"replay:FILE\"";
  // Try the longest name first, because another kind's name may be its prefix.
  for (std::string name = id; !name.empty();
       name.resize(name.find(':') == std::string::npos ? 0 : name.rfind(':')))
  {
    for (const DeviceKind& kind : kinds)
    {
      if (kind.Name == name)
      {
        return kind.Make(id, options, error);
      }
    }
  }
  for (const DeviceKind& kind : kinds)
  {
    known += ", \"" + kind.Name + "\"";
  }
  error = "There is no device \"" + id + "\": the kinds are " + known +
    ". Give an id that EnumerateDevices() lists.";
  return nullptr;
}

} // namespace VolumeHaptics
