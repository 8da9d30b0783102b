// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorFolder.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/Libraries.h"
#include "Core/Platform/OwnFile.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace VolumeHaptics
{
namespace
{

constexpr const char* Prefix = "libvolumehaptics-";
constexpr const char* Suffix = Libraries::Ending;

} // namespace

bool VendorFolder::IsName(const std::string& plugin)
{
  return !plugin.empty() &&
    std::all_of(plugin.begin(), plugin.end(),
      [](char c)
      {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
          c == '-' || c == '_';
      });
}

std::vector<std::string> VendorFolder::Split(const std::string& path)
{
  const std::string all = path.empty() ? ReadSafeVariable(Variable) : path;
  std::vector<std::string> folders;
  for (std::size_t from = 0; from <= all.size();)
  {
    const std::size_t end = std::min(all.find(Libraries::PathSeparator, from), all.size());
    if (end > from)
    {
      folders.push_back(all.substr(from, end - from));
    }
    from = end + 1;
  }
  return folders;
}

std::vector<VendorFile> VendorFolder::List(
  const std::vector<std::string>& folders, std::vector<std::string>& obstacles)
{
  namespace fs = std::filesystem;
  std::vector<VendorFile> found;
  for (const std::string& folder : folders)
  {
    if (!Files::IsAbsolute(folder))
    {
      obstacles.push_back(
        "\"" + folder + "\" is not searched, as it is relative. Name the whole path.");
      continue;
    }
    std::error_code error;
    std::vector<VendorFile> here;
    for (fs::directory_iterator file(Files::ToPath(folder), error), end; !error && file != end;
         file.increment(error))
    {
      const std::string name = Files::ToName(file->path().filename());
      const std::size_t least = std::strlen(Prefix) + std::strlen(Suffix);
      if (name.size() <= least || name.compare(0, std::strlen(Prefix), Prefix) != 0 ||
        name.compare(name.size() - std::strlen(Suffix), std::string::npos, Suffix) != 0)
      {
        continue;
      }
      const std::string plugin = name.substr(std::strlen(Prefix), name.size() - least);
      if (IsName(plugin))
      {
        here.push_back({ plugin, Files::ToName(file->path()) });
      }
    }
    if (error)
    {
      obstacles.push_back("\"" + folder + "\" can't be searched: " + error.message() + ".");
    }
    std::sort(here.begin(), here.end(),
      [](const VendorFile& a, const VendorFile& b) { return a.Plugin < b.Plugin; });
    for (VendorFile& file : here)
    {
      const bool isKnown = std::any_of(found.begin(), found.end(),
        [&file](const VendorFile& other) { return other.Plugin == file.Plugin; });
      if (!isKnown)
      {
        found.push_back(std::move(file));
      }
    }
  }
  return found;
}

} // namespace VolumeHaptics
