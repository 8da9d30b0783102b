// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/Files.h"

#include <cerrno>
#include <cstdio>
#include <random>

namespace VolumeHaptics
{
namespace Files
{

std::filesystem::path ToPath(const std::string& name)
{
  return std::filesystem::u8path(name);
}

std::string ToName(const std::filesystem::path& path)
{
  return path.u8string();
}

int CreateBeside(const std::string& file, Mode mode, std::string& name)
{
  std::string folder = GetFolder(file);
  folder += folder.back() == '/' ? "" : "/";
  std::random_device random;
  int descriptor = -1;
  constexpr int most = 100; // attempts; two random names of 64 bits are hardly ever equal
  for (int i = 0; i < most && descriptor < 0 && (i == 0 || errno == EEXIST); ++i)
  {
    char text[40];
    std::snprintf(text, sizeof(text), "VolumeHaptics%08x%08x.tmp", random(), random());
    name = folder + text;
    descriptor = Open(name, For::MakingNew, mode);
  }
  return descriptor;
}

} // namespace Files
} // namespace VolumeHaptics
