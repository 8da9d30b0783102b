// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes wheels that do not use HID-PID, "wheel" (WheelDriver.h).
 */
#ifndef WheelKind_h
#define WheelKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetWheelKind();

} // namespace VolumeHaptics

#endif
