// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads whether the user wants a guard. Available on all systems, unlike the guard itself.
 */
#ifndef GuardWish_h
#define GuardWish_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

/**
 * Returns whether a guard is wanted. Returns false if DeviceOptions::UseGuard is false or if
 * VOLUMEHAPTICS_GUARD is "off".
 */
bool IsGuardWanted(const DeviceOptions& options);

/** Returns the reason why a device has no guard on this system, and the cure. */
std::string MakeNoGuardText(const std::string& device);

} // namespace VolumeHaptics

#endif
