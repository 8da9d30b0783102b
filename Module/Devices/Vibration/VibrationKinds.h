// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes vibrating devices with an open protocol, in builds with Boost.Beast:
 * "vibration:bhaptics[:PLACE]", "vibration:weart[:HAND]" and "vibration:hapbeat:ADDRESS[:PORT]".
 *
 * The services of bHaptics and WEART run on this computer. A Hapbeat is on the network, so it is
 * neither searched nor listed: packets are sent only to the address that the user names, or to this
 * computer if there is none.
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
