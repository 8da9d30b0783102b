// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The guard's process: everything that the guard's program does.
 */
#ifndef GuardMain_h
#define GuardMain_h

#include "Devices/Common/HardwareDevice.h"

#include <functional>
#include <vector>

namespace VolumeHaptics
{

/**
 * Makes a driver from the words of GuardedDevice. Returns null and writes the reason to `error` if
 * this fails.
 */
using GuardedDriverMaker = std::function<std::unique_ptr<HardwareDriver>(
  const std::vector<std::string>& words, std::string& error)>;

/**
 * Serves one device for the program that has started this process, until that program requests the
 * end or has ended. Returns the exit status.
 */
int RunGuard(const std::vector<std::string>& arguments, const GuardedDriverMaker& make);

} // namespace VolumeHaptics

#endif
