// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/ControlGroup.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/**
 * Names of the files in a group's folder. Versions 1 and 2 of the kernel's interface have different
 * ones.
 */
struct Names
{
  const char* Limit;
  const char* Used;
  const char* Cached; ///< a word in memory.stat
};
constexpr Names FIRST = { "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file" };
constexpr Names SECOND = { "memory.max", "memory.current", "inactive_file" };

/** Reads a number. Returns `otherwise` if there is none, for example if the file contains "max". */
double ReadNumber(std::istream& in, double otherwise)
{
  double number = 0.0;
  return in >> number ? number : otherwise;
}

double ReadFile(const std::string& file, double otherwise)
{
  std::ifstream in(file);
  return ReadNumber(in, otherwise);
}

double ReadCached(const std::string& folder, const char* wanted)
{
  std::ifstream in(folder + "/memory.stat");
  std::string word;
  while (in >> word)
  {
    const double number = ReadNumber(in, 0.0);
    if (word == wanted)
    {
      return number;
    }
  }
  return 0.0;
}

/**
 * Returns how much memory a group and the groups above it leave. Some of their folders may be
 * hidden in a container.
 */
double ReadRoom(const std::string& root, std::string group, const Names& names)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  double room = none;
  for (bool isLast = false; !isLast;)
  {
    group.erase(group.find_last_not_of('/') + 1);
    isLast = group.empty();
    const std::string folder = root + group;
    const double limit = ReadFile(folder + "/" + names.Limit, none);
    const double used = ReadFile(folder + "/" + names.Used, 0.0);
    room = std::min(room, std::max(0.0, limit - used + ReadCached(folder, names.Cached)));
    group.erase(isLast ? 0 : group.rfind('/'));
  }
  return room;
}

} // namespace

double ReadGroupMemory(const std::string& groups, const std::string& root)
{
  double room = std::numeric_limits<double>::infinity();
  std::ifstream in(groups);
  std::string line;
  while (std::getline(in, line))
  {
    // A line is NUMBER:CONTROLLERS:/GROUP. Version 2 has the number 0 and no controllers.
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    if (controllers == ",,")
    {
      room = std::min(room, ReadRoom(root, group, SECOND));
    }
    else if (controllers.find(",memory,") != std::string::npos)
    {
      room = std::min(room, ReadRoom(root + "/memory", group, FIRST));
    }
  }
  return room;
}

} // namespace VolumeHaptics
