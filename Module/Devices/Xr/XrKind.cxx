// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Xr/XrKind.h"

#include "Devices/Xr/XrDevice.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

constexpr const char* XrId = "vibration:xr";

#if defined(VOLUME_HAPTICS_HAS_OPENXR)
constexpr bool HasXrModule = true;
#else
constexpr bool HasXrModule = false;
#endif

/** Returns the value of an environment variable; `other` if it is unset or empty. */
std::string ReadXdgVariable(const char* name, const std::string& other)
{
  const char* const value = std::getenv(name);
  return value && *value ? value : other;
}

std::vector<DeviceListing> ListXr()
{
  const std::string runtime = FindXrRuntime();
  if (!WhyNoXr(HasXrModule, runtime).empty())
  {
    return {};
  }
  return { { XrId, "Controllers of a headset, OpenXR runtime " + runtime + ": vibration, not force",
    "available to programs that draw for the headset, see vtkHapticXRController" } };
}

std::unique_ptr<DeviceBackend> MakeXr(
  const std::string& id, const DeviceOptions&, std::string& error)
{
  if (id != XrId)
  {
    error = "\"" + id + "\" is not a device id: give \"vibration:xr\", which has no number.";
    return nullptr;
  }
  return std::make_unique<XrDevice>();
}

std::string WhyNoXrHere()
{
  return WhyNoXr(HasXrModule, FindXrRuntime());
}

} // namespace

std::string FindXrRuntime()
{
  const std::string named = ReadXdgVariable("XR_RUNTIME_JSON", "");
  std::vector<std::string> files;
  if (!named.empty())
  {
    files.push_back(named);
  }
  else
  {
    const std::string home = ReadXdgVariable("HOME", "");
    std::istringstream folders(
      ReadXdgVariable("XDG_CONFIG_HOME", home.empty() ? home : home + "/.config") + ":" +
      ReadXdgVariable("XDG_CONFIG_DIRS", "/etc/xdg") + ":/etc");
    for (std::string folder; std::getline(folders, folder, ':');)
    {
      files.push_back(folder + "/openxr/1/active_runtime.json");
    }
  }
  for (const std::string& file : files)
  {
    if (file.front() == '/' && std::ifstream(file))
    {
      return file;
    }
  }
  return "";
}

std::string WhyNoXr(bool hasModule, [[maybe_unused]] const std::string& runtime)
{
  if (!hasModule)
  {
    return "needs VTK's module RenderingOpenXR, which this library was built without. Build VTK "
           "9.2 or later with -DVTK_MODULE_ENABLE_VTK_RenderingOpenXR=YES, and this library with "
           "that VTK and -DVolumeHaptics_USE_OPENXR=ON. A program that makes controllers vibrate "
           "by itself (vtkHapticVirtualHand::TakeVibration) can open it all the same.";
  }
#if defined(__linux__)
  if (runtime.empty())
  {
    return "no OpenXR runtime is active. Start the one of your headset, such as SteamVR or Monado, "
           "and make it the active one; or name its file in XR_RUNTIME_JSON.";
  }
#endif
  return "";
}

DeviceKind GetXrKind()
{
  return { XrId, &ListXr, &MakeXr, &WhyNoXrHere };
}

} // namespace VolumeHaptics
