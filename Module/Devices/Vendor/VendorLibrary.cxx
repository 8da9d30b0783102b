// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorLibrary.h"

#include "Devices/Common/OwnFile.h"
#include "Devices/Vendor/VendorFolder.h"

#include <algorithm>
#include <cctype>
#include <map>

#include <dlfcn.h>

namespace VolumeHaptics
{
namespace
{

constexpr int MostDevices = 64;

bool IsWhole(const VolumeHapticsVendorPlugin& table)
{
  return table.Count && table.Describe && table.Open && table.GetLimits && table.GetSerial &&
    table.Read && table.Write && table.LastError && table.Close;
}

/**
 * The table of a file's plug-in; null, with the reason and the cure. A refused library stays
 * loaded, too: the vendor's library may have started threads.
 */
const VolumeHapticsVendorPlugin* LoadTable(const std::string& real, std::string& error)
{
  void* const library = dlopen(real.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    // The loader names the missing part, usually the vendor's own library.
    const char* const reason = dlerror();
    error = "\"" + real + "\" can't be loaded: " + (reason ? reason : "no reason is given") +
      ". Install the vendor's SDK, and name the folder of its libraries in LD_LIBRARY_PATH if they "
      "are not in a folder of the system.";
    return nullptr;
  }
  using Getter = const VolumeHapticsVendorPlugin* (*)(std::uint32_t);
  const auto get = reinterpret_cast<Getter>(dlsym(library, "VolumeHapticsVendorGetPlugin"));
  if (!get)
  {
    error = "\"" + real +
      "\" is no plug-in: it does not export VolumeHapticsVendorGetPlugin (VendorPlugin.h).";
    return nullptr;
  }
  const VolumeHapticsVendorPlugin* const table = get(VOLUME_HAPTICS_VENDOR_VERSION);
  if (!table || table->Version != VOLUME_HAPTICS_VENDOR_VERSION || !IsWhole(*table))
  {
    error = "\"" + real + "\" is a plug-in for another version than " +
      std::to_string(VOLUME_HAPTICS_VENDOR_VERSION) +
      ", or leaves functions out. Build it again with the VendorPlugin.h of this version.";
    return nullptr;
  }
  return table;
}

} // namespace

std::shared_ptr<VendorLibrary> VendorLibrary::LoadFile(const std::string& path, std::string& error)
{
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<VendorLibrary>> loaded;
  const std::string real = FindOwnFile(path, NoGroup, error);
  if (real.empty())
  {
    return nullptr;
  }
  const std::lock_guard<std::mutex> lock(mutex);
  const auto known = loaded.find(real);
  if (known != loaded.end())
  {
    return known->second;
  }
  const VolumeHapticsVendorPlugin* const table = LoadTable(real, error);
  if (!table)
  {
    return nullptr;
  }
  std::shared_ptr<VendorLibrary> library(new VendorLibrary(table));
  loaded[real] = library;
  return library;
}

std::shared_ptr<VendorLibrary> VendorLibrary::Load(
  const std::string& plugin, const std::string& path, std::string& error)
{
  const std::vector<std::string> folders = VendorFolder::Split(path);
  std::vector<std::string> obstacles;
  const std::vector<VendorFile> files = VendorFolder::Find(folders, obstacles);
  const auto file = std::find_if(files.begin(), files.end(),
    [&plugin](const VendorFile& candidate) { return candidate.Plugin == plugin; });
  if (file != files.end())
  {
    return LoadFile(file->Path, error);
  }
  error = "There is no plug-in \"" + plugin + "\", the file libvolumehaptics-" + plugin + ".so";
  if (folders.empty())
  {
    error += std::string(": no folder is searched. Name the plug-in's folder in ") +
      VendorFolder::Variable + " or by SetVendorPath().";
    return nullptr;
  }
  error += ", in ";
  for (const std::string& folder : folders)
  {
    error += (&folder == &folders.front() ? "\"" : ", \"") + folder + "\"";
  }
  error += ". Build it (Examples/Vendor), and name its folder in ";
  error += std::string(VendorFolder::Variable) + " or by SetVendorPath().";
  for (const std::string& obstacle : obstacles)
  {
    error += " " + obstacle;
  }
  return nullptr;
}

std::string VendorLibrary::LastError(void* device) const
{
  const char* const text = this->Table->LastError(device);
  return text && *text ? text : "gives no reason.";
}

bool VendorLibrary::Look(std::string& error)
{
  const int count = this->Table->Count();
  if (count < 0)
  {
    error = this->LastError(nullptr);
    return false;
  }
  this->Known.clear();
  for (int number = 0; number < std::min(count, MostDevices); ++number)
  {
    char name[128] = "";
    char serial[128] = "";
    if (this->Table->Describe(number, name, sizeof(name), serial, sizeof(serial)) < 0)
    {
      error = this->LastError(nullptr);
      return false;
    }
    name[sizeof(name) - 1] = serial[sizeof(serial) - 1] = '\0';
    this->Known.push_back({ name, serial });
  }
  return true;
}

bool VendorLibrary::Describe(std::vector<Description>& devices, std::string& error)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const bool isKnown = this->OpenCount > 0 || this->Look(error);
  devices = this->Known;
  return isKnown;
}

void* VendorLibrary::Open(int number, std::string& error)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->OpenCount == 0 && !this->Look(error))
  {
    return nullptr;
  }
  const std::size_t count = this->Known.size();
  if (static_cast<std::size_t>(number) >= count)
  {
    error = count == 0
      ? "has no device. Plug it in, switch it on, and close programs that use it."
      : "has no device " + std::to_string(number) + ". Count from 0, as EnumerateDevices() does.";
    return nullptr;
  }
  Description& description = this->Known[static_cast<std::size_t>(number)];
  if (description.IsOpen)
  {
    error = "is in use by this program. Close() it there.";
    return nullptr;
  }
  void* const device = this->Table->Open(number);
  if (!device)
  {
    error = this->LastError(nullptr);
    return nullptr;
  }
  description.IsOpen = true;
  ++this->OpenCount;
  return device;
}

void VendorLibrary::Close(void* device, int number) noexcept
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Table->Close(device);
  this->Known[static_cast<std::size_t>(number)].IsOpen = false;
  --this->OpenCount;
}

std::string VendorLibrary::MakeIdentity(
  const std::string& plugin, int number, const std::string& serial)
{
  std::string word = serial.empty() ? "number:" + std::to_string(number) : serial;
  // The user's file of devices separates words by spaces.
  std::replace_if(
    word.begin(), word.end(), [](unsigned char c) { return std::isgraph(c) == 0 || c == '='; },
    '_');
  return "vendor:" + plugin + ":" + word;
}

} // namespace VolumeHaptics
