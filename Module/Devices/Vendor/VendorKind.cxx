// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorKind.h"

#include "Devices/Common/DeviceTexts.h"
#include "Devices/Vendor/VendorDriver.h"
#include "Devices/Vendor/VendorFolder.h"

namespace VolumeHaptics
{
namespace
{

std::vector<DeviceListing> ListVendors()
{
  std::vector<DeviceListing> all;
  std::vector<std::string> obstacles;
  for (const VendorFile& file : VendorFolder::List(VendorFolder::Split(""), obstacles))
  {
    std::string error;
    std::vector<VendorLibrary::Description> devices;
    const auto library = VendorLibrary::LoadFile(file.Path, error);
    if (library && library->Describe(devices, error))
    {
      int number = 0;
      for (const VendorLibrary::Description& device : devices)
      {
        all.push_back({ "vendor:" + file.Plugin + ":" + std::to_string(number), device.Name,
          device.IsOpen ? "in use" : "available",
          device.Serial.empty()
            ? std::string() // the serial number may be known only when the device is open
            : VendorLibrary::MakeIdentity(file.Plugin, number, device.Serial) });
        ++number;
      }
    }
  }
  return all;
}

/** Returns the obstacles of the plug-ins that can't be used, and of the kind itself. */
std::string WhyNoVendors()
{
  std::vector<std::string> obstacles;
  const std::vector<std::string> folders = VendorFolder::Split("");
  const std::vector<VendorFile> files = VendorFolder::List(folders, obstacles);
  for (const VendorFile& file : files)
  {
    std::string error;
    std::vector<VendorLibrary::Description> devices;
    const auto library = VendorLibrary::LoadFile(file.Path, error);
    if (!library)
    {
      obstacles.push_back(error);
    }
    else if (!library->Describe(devices, error))
    {
      obstacles.push_back("vendor:" + file.Plugin + " " + error);
    }
  }
  std::string text;
  if (folders.empty() || (files.empty() && obstacles.empty()))
  {
    text = std::string("no plug-in for a vendor's library is found. Build one against the "
                       "vendor's SDK (Examples/Vendor), and name its folder in ") +
      VendorFolder::Variable + ".";
  }
  for (const std::string& obstacle : obstacles)
  {
    text += (text.empty() ? "" : " ") + obstacle;
  }
  return text;
}

std::unique_ptr<DeviceBackend> MakeVendor(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  const std::size_t first = id.find(':');
  const std::size_t second = first == std::string::npos ? first : id.find(':', first + 1);
  const std::string plugin = first == std::string::npos
    ? std::string()
    : id.substr(first + 1, second == std::string::npos ? second : second - first - 1);
  if (!VendorFolder::IsName(plugin))
  {
    error = "\"" + id +
      "\" is not a device id: give \"vendor:PLUGIN\" or \"vendor:PLUGIN:N\", with the plug-in's "
      "name "
      "and N counting from 0, such as \"vendor:forcedimension\".";
    return nullptr;
  }
  const int number = ReadDeviceNumber(id, "vendor:" + plugin, error);
  return number < 0 ? nullptr
                    : std::make_unique<HardwareDevice>(
                        std::make_unique<VendorDriver>(plugin, number, options.VendorPath));
}

} // namespace

DeviceKind GetVendorKind()
{
  return { "vendor", &ListVendors, &MakeVendor, &WhyNoVendors };
}

} // namespace VolumeHaptics
