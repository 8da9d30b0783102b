// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The limit of memory that a container or a service manager gives a process.
 */
#ifndef ControlGroup_h
#define ControlGroup_h

#include <string>

namespace VolumeHaptics
{

/**
 * Returns how many bytes of memory this process's control group and the groups above it leave. What
 * the kernel would drop, which are cached files, counts as free. Infinite without a limit, and on
 * systems without control groups.
 *
 * @param groups a file like /proc/self/cgroup
 * @param root   the folder where the groups' file system is
 */
double ReadGroupMemory(
  const std::string& groups = "/proc/self/cgroup", const std::string& root = "/sys/fs/cgroup");

} // namespace VolumeHaptics

#endif
