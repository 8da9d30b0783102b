// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes what vibrates by an open protocol, in builds with Boost.Beast:
 * "vibration:bhaptics[:PLACE]", "vibration:weart[:HAND]" and "vibration:hapbeat:ADDRESS[:PORT]".
 *
 * The services of bHaptics and WEART are reached on this computer only. A Hapbeat is reached over
 * the network, so it is neither looked for nor listed: only the address that the user names gets
 * packets, and without one, this computer.
 */
#ifndef VibrationKinds_h
#define VibrationKinds_h

#include "Devices/Common/DeviceKind.h"
#include "Devices/Common/HardwareDevice.h"

namespace VolumeHaptics
{

std::vector<DeviceKind> GetVibrationKinds();

/** Makes the driver for a guard whose words name WEART. Returns null for other words. */
std::unique_ptr<HardwareDriver> MakeVibrationFromWords(const std::vector<std::string>& words);

} // namespace VolumeHaptics

#endif
