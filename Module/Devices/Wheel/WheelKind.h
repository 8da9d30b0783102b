// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kind of devices "wheel": wheels that do not speak HID-PID (WheelDriver.h).
 */
#ifndef WheelKind_h
#define WheelKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetWheelKind();

} // namespace VolumeHaptics

#endif
