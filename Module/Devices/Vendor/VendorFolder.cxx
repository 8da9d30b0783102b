// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorFolder.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr const char* Prefix = "libvolumehaptics-";
constexpr const char* Suffix = ".so";

const char* ReadVariable()
{
#if defined(__GLIBC__)
  return secure_getenv(VendorFolder::Variable);
#else
  return getuid() == geteuid() && getgid() == getegid() ? std::getenv(VendorFolder::Variable)
                                                        : nullptr;
#endif
}

/** Empty if only this user and root can write it; else the reason and the cure. */
std::string ReasonAgainst(const std::string& path, bool isAbove)
{
  struct stat info
  {
  };
  if (lstat(path.c_str(), &info) != 0)
  {
    return "\"" + path + "\" can't be looked at: " + std::strerror(errno) + ".";
  }
  if (info.st_uid != 0 && info.st_uid != geteuid())
  {
    return "\"" + path +
      "\" belongs to another user, who could put anything there. Copy the plug-in to a folder of "
      "your own.";
  }
  const bool isOpen = (info.st_mode & (S_IWGRP | S_IWOTH)) != 0;
  const bool isSticky = S_ISDIR(info.st_mode) && (info.st_mode & S_ISVTX) != 0;
  return !isOpen || (isAbove && isSticky) ? std::string()
                                          : "others may write \"" + path +
      "\", and so what would be loaded. Run: chmod go-w '" + path + "'";
}

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
  const char* const variable = path.empty() ? ReadVariable() : nullptr;
  const std::string all = variable ? variable : path;
  std::vector<std::string> folders;
  for (std::size_t from = 0; from <= all.size();)
  {
    const std::size_t end = std::min(all.find(':', from), all.size());
    if (end > from)
    {
      folders.push_back(all.substr(from, end - from));
    }
    from = end + 1;
  }
  return folders;
}

std::vector<VendorFile> VendorFolder::Find(
  const std::vector<std::string>& folders, std::vector<std::string>& obstacles)
{
  namespace fs = std::filesystem;
  std::vector<VendorFile> found;
  for (const std::string& folder : folders)
  {
    if (folder[0] != '/')
    {
      obstacles.push_back("\"" + folder +
        "\" is not searched, as it does not begin with a slash. Name the whole path.");
      continue;
    }
    std::error_code error;
    std::vector<VendorFile> here;
    for (fs::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error))
    {
      const std::string name = file->path().filename().string();
      const std::size_t least = std::strlen(Prefix) + std::strlen(Suffix);
      if (name.size() <= least || name.compare(0, std::strlen(Prefix), Prefix) != 0 ||
        name.compare(name.size() - std::strlen(Suffix), std::string::npos, Suffix) != 0)
      {
        continue;
      }
      const std::string plugin = name.substr(std::strlen(Prefix), name.size() - least);
      if (IsName(plugin))
      {
        here.push_back({ plugin, file->path().string() });
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

std::string VendorFolder::Check(const std::string& path, std::string& error)
{
  char* const resolved = realpath(path.c_str(), nullptr);
  if (!resolved)
  {
    error = "\"" + path + "\" can't be found: " + std::strerror(errno) + ".";
    return {};
  }
  const std::string real = resolved;
  std::free(resolved);
  struct stat info
  {
  };
  if (stat(real.c_str(), &info) != 0 || !S_ISREG(info.st_mode))
  {
    error = "\"" + path + "\" is not a file.";
    return {};
  }
  error = ReasonAgainst(real, false);
  for (std::size_t end = real.rfind('/'), level = 0; error.empty() && end != std::string::npos;
       ++level)
  {
    error = ReasonAgainst(end == 0 ? "/" : real.substr(0, end), level > 0);
    end = end == 0 ? std::string::npos : real.rfind('/', end - 1);
  }
  return error.empty() ? real : std::string();
}

} // namespace VolumeHaptics
