// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The main function of the guard's process.
 */
#ifndef GuardMain_h
#define GuardMain_h

#include "Devices/Common/HardwareDevice.h"

#include <functional>
#include <vector>

namespace VolumeHaptics
{

/**
 * Makes a driver from the words of GuardedDevice. On failure, returns null and writes the reason to
 * `error`.
 */
using GuardedDriverMaker = std::function<std::unique_ptr<HardwareDriver>(
  const std::vector<std::string>& words, std::string& error)>;

/**
 * Serves one device for the program that started this process, until the program requests the end
 * or ends itself. Returns the exit status.
 */
int RunGuard(const std::vector<std::string>& arguments, const GuardedDriverMaker& make);

} // namespace VolumeHaptics

#endif
