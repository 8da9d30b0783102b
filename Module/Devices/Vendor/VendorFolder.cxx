// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vendor/VendorFolder.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr const char* Prefix = "libvolumehaptics-";
constexpr const char* Suffix = ".so";
constexpr int MostLinks = 40; // on one path, as in Linux

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
  // The mode of a link means nothing: its folder says who can replace it.
  const bool isOpen = !S_ISLNK(info.st_mode) && (info.st_mode & (S_IWGRP | S_IWOTH)) != 0;
  const bool isSticky = S_ISDIR(info.st_mode) && (info.st_mode & S_ISVTX) != 0;
  return !isOpen || (isAbove && isSticky) ? std::string()
                                          : "others may write \"" + path +
      "\", and so what would be loaded. Run: chmod go-w '" + path + "'";
}

/**
 * The real path. Empty, with the reason and the cure, if another user can write a link or a folder
 * on the way to it.
 */
std::string Resolve(const std::string& path, std::string& error)
{
  namespace fs = std::filesystem;
  const fs::path named = path;
  std::deque<fs::path> ahead(named.begin(), named.end());
  fs::path real = "/";
  int links = 0;
  error = ReasonAgainst(real.string(), true);
  while (error.empty() && !ahead.empty())
  {
    const fs::path part = ahead.front();
    ahead.pop_front();
    if (part.empty() || part == ".")
    {
      continue;
    }
    if (part == "/" || part == "..")
    {
      real = part == "/" ? part : real.parent_path();
      continue;
    }
    const fs::path next = real / part;
    error = ReasonAgainst(next.string(), true);
    std::error_code isNoLink;
    const fs::path target = fs::read_symlink(next, isNoLink);
    if (isNoLink)
    {
      real = next;
    }
    else if (++links > MostLinks)
    {
      error = "\"" + path + "\" has too many links.";
    }
    else
    {
      ahead.insert(ahead.begin(), target.begin(), target.end());
    }
  }
  return error.empty() ? real.string() : std::string();
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
  namespace fs = std::filesystem;
  // Others may neither add links to the folder that is searched nor replace the file.
  const std::string folder = Resolve(fs::path(path).parent_path().string(), error);
  const std::string real = error.empty() ? Resolve(path, error) : std::string();
  std::error_code ignored;
  if (error.empty() && !fs::is_regular_file(real, ignored))
  {
    error = "\"" + path + "\" is not a file.";
  }
  if (error.empty())
  {
    error = ReasonAgainst(folder, false);
  }
  if (error.empty())
  {
    error = ReasonAgainst(fs::path(real).parent_path().string(), false);
  }
  return error.empty() ? real : std::string();
}

} // namespace VolumeHaptics
