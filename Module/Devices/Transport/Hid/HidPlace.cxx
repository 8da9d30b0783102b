// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidPort.h"

#include <algorithm>

#if defined(__linux__)
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace
{

/** As UTF-8. */
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
#endif

} // namespace

std::mutex& GetHidMutex()
{
  static std::mutex mutex;
  return mutex;
}

std::vector<HidPlace> FindHidDevices()
{
  const std::lock_guard<std::mutex> lock(GetHidMutex());
  static const int isInitialized = hid_init();
  std::vector<HidPlace> places;
  if (isInitialized != 0)
  {
    return places;
  }
  hid_device_info* const list = hid_enumerate(0, 0);
  for (const hid_device_info* info = list; info; info = info->next)
  {
    // A device is listed once for each of its collections.
    const auto isSame = [info](const HidPlace& place) { return place.Path == info->path; };
    if (info->path && std::none_of(places.begin(), places.end(), isSame))
    {
      places.push_back({ info->path, Narrow(info->manufacturer_string),
        Narrow(info->product_string), info->vendor_id, info->product_id, info->usage_page });
    }
  }
  hid_free_enumeration(list);
  // hidraw10 comes after hidraw9.
  std::sort(places.begin(), places.end(),
    [](const HidPlace& a, const HidPlace& b)
    { return a.Path.size() != b.Path.size() ? a.Path.size() < b.Path.size() : a.Path < b.Path; });
  return places;
}

std::string HidPlace::GetLabel() const
{
  std::string label = this->Product.empty() ? "A HID device" : this->Product;
  // Some makers put themselves into the name of the product.
  if (!this->Maker.empty() && label.compare(0, this->Maker.size(), this->Maker) != 0)
  {
    label = this->Maker + " " + label;
  }
  return label + " (" + this->Path + ")";
}

bool HidPlace::ReadDescriptor(HidReportDescriptor& descriptor, std::string& error) const
{
#if defined(__linux__)
  // The system's copy, which everyone may read; hidapi hands it out from version 0.14 on only.
  const std::string node = this->Path.substr(this->Path.rfind('/') + 1);
  const std::vector<std::uint8_t> bytes = ReadAll(
    "/sys/class/hidraw/" + node + "/device/report_descriptor", HidReportDescriptor::MaximumSize);
  if (!bytes.empty())
  {
    return descriptor.Parse(bytes.data(), bytes.size(), error);
  }
#else
  (void)descriptor;
#endif
  error = "the system does not hand out the report descriptor";
  return false;
}

HidClaim::Answer HidClaim::Take(const std::string& path) noexcept
{
  this->Release();
#if defined(__linux__)
  this->Descriptor = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (this->Descriptor < 0)
  {
    return errno == EACCES || errno == EPERM ? Answer::Forbidden : Answer::Missing;
  }
  if (flock(this->Descriptor, LOCK_EX | LOCK_NB) != 0)
  {
    this->Release();
    return Answer::InUse;
  }
#else
  (void)path;
#endif
  return Answer::Held;
}

void HidClaim::Release() noexcept
{
#if defined(__linux__)
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
#endif
}

} // namespace VolumeHaptics
