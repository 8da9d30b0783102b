// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidDeviceInfo.h"

#include "Devices/Common/DeviceTexts.h"
#include "Devices/Transport/Hid/HidClaim.h"

#include <hidapi.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#if defined(__linux__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace
{

/** Converts a wide text to UTF-8. */
std::string Narrow(const wchar_t* wide)
{
  std::string text;
  for (; wide && *wide; ++wide)
  {
    const auto c = static_cast<std::uint32_t>(*wide);
    const auto tail = [c](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3F)); };
    if (c < 0x80)
    {
      text += static_cast<char>(c);
    }
    else if (c < 0x800)
    {
      (text += static_cast<char>(0xC0 | c >> 6)) += tail(0);
    }
    else if (c < 0x10000)
    {
      ((text += static_cast<char>(0xE0 | c >> 12)) += tail(6)) += tail(0);
    }
    else
    {
      (((text += static_cast<char>(0xF0 | (c >> 18 & 7))) += tail(12)) += tail(6)) += tail(0);
    }
  }
  return text;
}

#if defined(__linux__)
constexpr std::size_t LongestEvent = 4096; // bytes; the kernel's files have a few lines

std::vector<std::uint8_t> ReadAll(const std::string& path, std::size_t most)
{
  std::vector<std::uint8_t> bytes;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
  {
    return bytes;
  }
  std::uint8_t part[1024];
  for (ssize_t size = 1; size > 0 && bytes.size() <= most;)
  {
    size = read(file, part, sizeof(part));
    bytes.insert(bytes.end(), part, part + std::max<ssize_t>(size, 0));
  }
  close(file);
  return bytes;
}
#elif HID_API_VERSION >= HID_API_MAKE_VERSION(0, 14, 0)
/**
 * Reads the descriptor through hidapi, which composes it where the system has none, as on Windows.
 */
std::vector<std::uint8_t> AskLibrary(const std::string& path)
{
  std::vector<std::uint8_t> bytes(HID_API_MAX_REPORT_DESCRIPTOR_SIZE);
  const std::lock_guard<std::mutex> lock(GetHidMutex());
  hid_device* const device = hid_open_path(path.c_str());
  const int size =
    device != nullptr ? hid_get_report_descriptor(device, bytes.data(), bytes.size()) : 0;
  hid_close(device);
  bytes.resize(static_cast<std::size_t>(std::clamp(size, 0, static_cast<int>(bytes.size()))));
  return bytes;
}
#endif

} // namespace

std::vector<HidDeviceInfo> ListHidDevices()
{
  const std::lock_guard<std::mutex> lock(GetHidMutex());
  static const int isInitialized = hid_init();
  std::vector<HidDeviceInfo> devices;
  if (isInitialized != 0)
  {
    return devices;
  }
  hid_device_info* const list = hid_enumerate(0, 0);
  for (const hid_device_info* entry = list; entry; entry = entry->next)
  {
    // hidapi lists a device once for each of its collections; add it only once.
    const auto isSame = [entry](const HidDeviceInfo& info) { return info.Path == entry->path; };
    if (entry->path && std::none_of(devices.begin(), devices.end(), isSame))
    {
      devices.push_back(
        { entry->path, Narrow(entry->manufacturer_string), Narrow(entry->product_string),
          entry->vendor_id, entry->product_id, entry->usage_page, Narrow(entry->serial_number) });
    }
  }
  hid_free_enumeration(list);
  // Sort by length first, because hidraw10 must come after hidraw9.
  std::sort(devices.begin(), devices.end(),
    [](const HidDeviceInfo& a, const HidDeviceInfo& b)
    { return a.Path.size() != b.Path.size() ? a.Path.size() < b.Path.size() : a.Path < b.Path; });
  return devices;
}

std::vector<HidDeviceInfo> ListHidDevices(bool (*isSome)(const HidDeviceInfo&))
{
  std::vector<HidDeviceInfo> devices = ListHidDevices();
  devices.erase(std::remove_if(devices.begin(), devices.end(), std::not_fn(isSome)), devices.end());
  return devices;
}

std::string HidDeviceInfo::GetLabel() const
{
  std::string label = this->Product.empty() ? "A HID device" : this->Product;
  // Omit the maker if the product's name begins with it.
  if (!this->Maker.empty() && label.compare(0, this->Maker.size(), this->Maker) != 0)
  {
    label = this->Maker + " " + label;
  }
  return label + " (" + this->Path + ")";
}

std::string HidDeviceInfo::MakeIdentity(const char* kind) const
{
  char numbers[16];
  std::snprintf(numbers, sizeof(numbers), ":%04x:%04x", this->Vendor, this->ProductId);
  return kind + (numbers + (this->Serial.empty() ? std::string() : ":" + this->Serial));
}

bool HidDeviceInfo::ReadDescriptor(HidReportDescriptor& descriptor, std::string& error) const
{
  std::vector<std::uint8_t> bytes;
#if defined(__linux__)
  // Read the system's copy, which needs no permission.
  const std::string node = this->Path.substr(this->Path.rfind('/') + 1);
  bytes = ReadAll(
    "/sys/class/hidraw/" + node + "/device/report_descriptor", HidReportDescriptor::MaximumSize);
#elif HID_API_VERSION >= HID_API_MAKE_VERSION(0, 14, 0)
  bytes = AskLibrary(this->Path);
#endif
  if (!bytes.empty())
  {
    return descriptor.Parse(bytes.data(), bytes.size(), error);
  }
  error = "the system does not hand out the report descriptor (other systems than Linux need "
          "hidapi 0.14 or later)";
  return false;
}

std::string HidDeviceInfo::GetPermissionCure() const
{
  bool isBluetooth = false;
#if defined(__linux__)
  const std::string node = this->Path.substr(this->Path.rfind('/') + 1);
  const std::vector<std::uint8_t> bytes =
    ReadAll("/sys/class/hidraw/" + node + "/device/uevent", LongestEvent);
  const std::string event(bytes.begin(), bytes.end());
  isBluetooth = event.find("HID_ID=0005:") != std::string::npos;
#endif
  return PermissionCure("hidraw", this->Vendor, this->ProductId, isBluetooth);
}

std::string HidDeviceInfo::GetState() const
{
  HidClaim claim;
  const std::lock_guard<std::mutex> lock(GetHidMutex());
  switch (claim.Own(this->Path))
  {
    case HidClaim::Answer::InUse:
      return "in use";
    case HidClaim::Answer::Forbidden:
      return this->GetPermissionCure();
    case HidClaim::Answer::Missing:
      return "unplugged. Plug it in again.";
    default:
      return "available";
  }
}

} // namespace VolumeHaptics
