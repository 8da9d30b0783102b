// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether the user wants a guard. Available on all systems, unlike the guard itself.
 */
#ifndef GuardWish_h
#define GuardWish_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

/** Returns false if DeviceOptions::UseGuard is false, or VOLUMEHAPTICS_GUARD=off. */
bool IsGuardWanted(const DeviceOptions& options);

/** Returns the reason and the cure for a device on a system that has no guard. */
std::string MakeNoGuardText(const std::string& device);

} // namespace VolumeHaptics

#endif
