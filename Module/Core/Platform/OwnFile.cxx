// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/OwnFile.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/Libraries.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"

#include <aclapi.h>
#else
#include <cerrno>
#include <cstring>
#include <deque>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace
{

constexpr int MostFoldersUp = 6;

} // namespace

#if defined(_WIN32)

namespace
{

constexpr DWORD Replacing = DELETE | FILE_DELETE_CHILD | WRITE_DAC | WRITE_OWNER | GENERIC_ALL;
constexpr DWORD Changing = Replacing | FILE_WRITE_DATA | FILE_APPEND_DATA | GENERIC_WRITE;

/**
 * Returns whether an account is this user, the system or its administrators, or a placeholder for
 * the owner.
 */
bool IsTrusted(PSID account, PSID user)
{
  for (const WELL_KNOWN_SID_TYPE kind : { WinLocalSystemSid, WinBuiltinAdministratorsSid,
         WinCreatorOwnerSid, WinCreatorOwnerRightsSid })
  {
    if (IsWellKnownSid(account, kind))
    {
      return true;
    }
  }
  // TrustedInstaller, the account of the system's installer, owns the folders of programs:
  // S-1-5-80-95600...
  const bool isService = *GetSidSubAuthorityCount(account) == 6 &&
    *GetSidSubAuthority(account, 0) == 80 && *GetSidSubAuthority(account, 1) == 956008885;
  return isService || EqualSid(account, user);
}

/**
 * Returns why a path is not safe, and the remedy. Returns an empty text if only this user and the
 * administrators have the rights in `refused`.
 */
std::string ReasonAgainst(const std::filesystem::path& path, DWORD refused)
{
  const std::string name = Files::ToName(path);
  HANDLE token = nullptr;
  if (!OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY, &token))
  {
    return "\"" + name + "\" can't be looked at: " + DescribeWindowsError(GetLastError()) + ".";
  }
  const WindowsHandle closed(token);
  alignas(TOKEN_USER) char user[sizeof(TOKEN_USER) + SECURITY_MAX_SID_SIZE];
  DWORD size = 0;
  PSID owner = nullptr;
  PACL list = nullptr;
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  DWORD failure = GetTokenInformation(token, TokenUser, user, sizeof(user), &size) ? ERROR_SUCCESS
                                                                                   : GetLastError();
  if (failure == ERROR_SUCCESS)
  {
    failure = GetNamedSecurityInfoW(const_cast<wchar_t*>(path.c_str()), SE_FILE_OBJECT,
      OWNER_SECURITY_INFORMATION | DACL_SECURITY_INFORMATION, &owner, nullptr, &list, nullptr,
      &descriptor);
  }
  if (failure != ERROR_SUCCESS)
  {
    return "\"" + name + "\" can't be looked at: " + DescribeWindowsError(failure) + ".";
  }
  const PSID self = reinterpret_cast<const TOKEN_USER*>(user)->User.Sid;
  std::string reason;
  if (!IsTrusted(owner, self))
  {
    reason = "\"" + name +
      "\" belongs to another user, who could put anything there. Copy the file to a folder of "
      "your own.";
  }
  bool isOpen = list == nullptr; // without a list, everybody has all rights
  for (DWORD i = 0; list && i < list->AceCount; ++i)
  {
    ACCESS_ALLOWED_ACE* entry = nullptr;
    if (GetAce(list, i, reinterpret_cast<void**>(&entry)) &&
      entry->Header.AceType == ACCESS_ALLOWED_ACE_TYPE &&
      (entry->Header.AceFlags & INHERIT_ONLY_ACE) == 0 && (entry->Mask & refused) != 0)
    {
      isOpen = isOpen || !IsTrusted(&entry->SidStart, self);
    }
  }
  LocalFree(descriptor);
  if (reason.empty() && isOpen)
  {
    reason = "others may write \"" + name +
      "\", and so what would be run. Take the right to write it from them (Properties, Security), "
      "or copy the file to a folder of your own.";
  }
  return reason;
}

} // namespace

FileGroup FindPrivateGroup()
{
  return NoGroup; // Windows has lists of accounts
}

std::string FindOwnFile(const std::string& path, FileGroup, std::string& error)
{
  namespace fs = std::filesystem;
  std::error_code trouble;
  const fs::path real = fs::canonical(Files::ToPath(path), trouble);
  if (trouble)
  {
    error = "\"" + path + "\" can't be looked at: " + trouble.message() + ".";
    return {};
  }
  if (!fs::is_regular_file(real, trouble))
  {
    error = "\"" + path + "\" is not a file.";
    return {};
  }
  error = ReasonAgainst(real, Changing);
  DWORD refused = Changing;
  for (fs::path folder = real.parent_path(); error.empty(); folder = folder.parent_path())
  {
    error = ReasonAgainst(folder, refused);
    refused = Replacing;
    if (folder == folder.parent_path())
    {
      break;
    }
  }
  return error.empty() ? Files::ToName(real) : std::string();
}

#else

namespace
{

constexpr int MostLinks = 40; // most symbolic links that a path may follow, as in Linux

/**
 * Returns why a path is not safe, and the remedy. Returns an empty text if only this user, root and
 * a trusted group can write it.
 */
std::string ReasonAgainst(const std::string& path, FileGroup trusted, bool isAbove)
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
  // The mode of a link is ignored, because its folder determines who can replace it.
  const bool isOpen = !S_ISLNK(info.st_mode) && (info.st_mode & open) != 0;
  const bool isSticky = S_ISDIR(info.st_mode) && (info.st_mode & S_ISVTX) != 0;
  return !isOpen || (isAbove && isSticky)
    ? std::string()
    : "others may write \"" + path + "\", and so what would be run. Run: chmod go-w '" + path + "'";
}

/**
 * Returns the real path. If another user can write a link or a folder in the path, returns an empty
 * path and writes the reason and the remedy to `error`.
 */
std::string Resolve(const std::string& path, FileGroup trusted, std::string& error)
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

FileGroup FindPrivateGroup()
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

std::string FindOwnFile(const std::string& path, FileGroup trusted, std::string& error)
{
  namespace fs = std::filesystem;
  // Other users must not be able to add links to the named folder, or to replace the file.
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

#endif

namespace
{
bool MayRun([[maybe_unused]] const std::filesystem::path& path)
{
#if defined(_WIN32)
  return true;
#else
  return access(path.c_str(), X_OK) == 0;
#endif
}
} // namespace

std::string FindProgramNear(const std::string& file, const char* program, std::string& obstacle)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const FileGroup trusted = FindPrivateGroup();
#if defined(_WIN32)
  const std::string name = std::string(program) + ".exe";
#else
  const std::string name = program;
#endif
  fs::path folder = fs::canonical(Files::ToPath(file), ignored).parent_path();
  for (int up = 0; up <= MostFoldersUp && !folder.empty(); ++up, folder = folder.parent_path())
  {
    for (const fs::path& path : { folder / name, folder / "bin" / name })
    {
      if (fs::is_regular_file(path, ignored) && MayRun(path))
      {
        std::string reason;
        std::string real = FindOwnFile(Files::ToName(path), trusted, reason);
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
  const std::string library = Libraries::FindFileOf(code);
  std::string found;
  if (!library.empty())
  {
    found = FindProgramNear(library, program, obstacle);
  }
  return found.empty() ? FindProgramNear(Libraries::FindOwnProgram(), program, obstacle) : found;
}

std::string ReadSafeVariable(const char* name)
{
#if defined(_WIN32)
  return Files::GetVariable(name);
#elif defined(__GLIBC__)
  const char* const value = secure_getenv(name);
  return value ? value : "";
#else
  return getuid() == geteuid() && getgid() == getegid() ? Files::GetVariable(name) : "";
#endif
}

} // namespace VolumeHaptics
