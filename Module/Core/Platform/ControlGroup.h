// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the limit of memory that a container or a service manager sets for a process.
 */
#ifndef ControlGroup_h
#define ControlGroup_h

#include <string>

namespace VolumeHaptics
{

/**
 * Returns how many bytes of memory this process's control group and the groups above it leave.
 * Cached files count as free memory, because the kernel would drop them. Returns infinity if there
 * is no limit, and on systems without control groups.
 *
 * @param groups a file with the format of /proc/self/cgroup
 * @param root   the folder of the groups' file system
 */
double ReadGroupMemory(
  const std::string& groups = "/proc/self/cgroup", const std::string& root = "/sys/fs/cgroup");

} // namespace VolumeHaptics

#endif
