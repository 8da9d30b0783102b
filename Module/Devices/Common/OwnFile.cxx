// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/OwnFile.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <vector>

#include <dlfcn.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr int MostLinks = 40; // limit of the links in a path, as in Linux
constexpr int MostFoldersUp = 6;

/**
 * Returns why a path is not safe, and the cure. Returns an empty text if only this user, root and a
 * trusted group can write it.
 */
std::string ReasonAgainst(const std::string& path, gid_t trusted, bool isAbove)
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
      "\" belongs to another user, who could put anything there. Copy the file to a folder of "
      "your own.";
  }
  const mode_t open = trusted != NoGroup && info.st_gid == trusted ? S_IWOTH : S_IWGRP | S_IWOTH;
  // The mode of a link does not count, because its folder determines who can replace it.
  const bool isOpen = !S_ISLNK(info.st_mode) && (info.st_mode & open) != 0;
  const bool isSticky = S_ISDIR(info.st_mode) && (info.st_mode & S_ISVTX) != 0;
  return !isOpen || (isAbove && isSticky)
    ? std::string()
    : "others may write \"" + path + "\", and so what would be run. Run: chmod go-w '" + path + "'";
}

/**
 * Returns the real path. If another user can write a link or a folder in the path, returns an empty
 * path and writes the reason and the cure to `error`.
 */
std::string Resolve(const std::string& path, gid_t trusted, std::string& error)
{
  namespace fs = std::filesystem;
  const fs::path named = path;
  std::deque<fs::path> ahead(named.begin(), named.end());
  fs::path real = "/";
  int links = 0;
  error = ReasonAgainst(real.string(), trusted, true);
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
    error = ReasonAgainst(next.string(), trusted, true);
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

gid_t FindPrivateGroup()
{
  std::vector<char> userText(1 << 16);
  std::vector<char> groupText(1 << 16);
  passwd user{};
  group own{};
  passwd* foundUser = nullptr;
  group* foundGroup = nullptr;
  if (geteuid() == 0 ||
    getpwuid_r(geteuid(), &user, userText.data(), userText.size(), &foundUser) != 0 ||
    foundUser == nullptr ||
    getgrgid_r(user.pw_gid, &own, groupText.data(), groupText.size(), &foundGroup) != 0 ||
    foundGroup == nullptr || std::strcmp(own.gr_name, user.pw_name) != 0)
  {
    return NoGroup;
  }
  for (char** member = own.gr_mem; *member != nullptr; ++member)
  {
    if (std::strcmp(*member, user.pw_name) != 0)
    {
      return NoGroup;
    }
  }
  return own.gr_gid;
}

std::string FindOwnFile(const std::string& path, gid_t trusted, std::string& error)
{
  namespace fs = std::filesystem;
  // Others must neither be able to add links to the named folder nor to replace the file.
  const std::string folder = Resolve(fs::path(path).parent_path().string(), trusted, error);
  const std::string real = error.empty() ? Resolve(path, trusted, error) : std::string();
  std::error_code ignored;
  if (error.empty() && !fs::is_regular_file(real, ignored))
  {
    error = "\"" + path + "\" is not a file.";
  }
  if (error.empty())
  {
    error = ReasonAgainst(folder, trusted, false);
  }
  if (error.empty())
  {
    error = ReasonAgainst(fs::path(real).parent_path().string(), trusted, false);
  }
  return error.empty() ? real : std::string();
}

std::string FindProgramNear(const std::string& file, const char* program, std::string& obstacle)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const gid_t trusted = FindPrivateGroup();
  fs::path folder = fs::canonical(file, ignored).parent_path();
  for (int up = 0; up <= MostFoldersUp && !folder.empty(); ++up, folder = folder.parent_path())
  {
    for (const fs::path& path : { folder / program, folder / "bin" / program })
    {
      if (fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0)
      {
        std::string reason;
        std::string real = FindOwnFile(path.string(), trusted, reason);
        if (!real.empty())
        {
          return real;
        }
        obstacle = obstacle.empty() ? reason : obstacle;
      }
    }
  }
  return {};
}

std::string FindProgramOfLibrary(const void* code, const char* program, std::string& obstacle)
{
  Dl_info info{};
  std::string found;
  if (dladdr(code, &info) != 0)
  {
    found = FindProgramNear(info.dli_fname, program, obstacle);
  }
  return found.empty() ? FindProgramNear("/proc/self/exe", program, obstacle) : found;
}

const char* ReadSafeVariable(const char* name)
{
#if defined(__GLIBC__)
  return secure_getenv(name);
#else
  return getuid() == geteuid() && getgid() == getegid() ? std::getenv(name) : nullptr;
#endif
}

} // namespace VolumeHaptics
