// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** POSIX functions that tests use, implemented for Windows. */
#ifndef Portable_h
#define Portable_h

#include "Core/Platform/Files.h"

#include <cstdlib>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>

#if defined(_WIN32)
#include <process.h>
#else
#include <unistd.h>
#endif

#if defined(_WIN32)
/// Sets an environment variable. Name and value are in UTF-8.
inline int setenv(const char* name, const char* value, int)
{
  const std::string text = std::string(name) + "=" + value;
  return _wputenv(std::filesystem::u8path(text).c_str());
}
inline int unsetenv(const char* name)
{
  return setenv(name, "", 1);
}
#endif

inline long GetProcessNumber()
{
#if defined(_WIN32)
  return _getpid();
#else
  return getpid();
#endif
}

/// Creates a folder with a new name that starts with `begin`.
inline std::filesystem::path MakeNewFolder(const std::filesystem::path& begin)
{
#if defined(_WIN32)
  std::random_device random;
  const std::filesystem::path path = begin.string() + std::to_string(random());
  if (!std::filesystem::create_directory(path))
#else
  std::string name = begin.string() + "XXXXXX";
  const std::filesystem::path path = mkdtemp(name.data()) ? name : "";
  if (path.empty())
#endif
  {
    throw std::runtime_error("no folder can be made beside " + begin.string());
  }
  return path;
}

#endif
