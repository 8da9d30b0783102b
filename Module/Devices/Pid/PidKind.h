// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes force-feedback sticks and wheels (HID PID), "pid:VVVV:PPPP", in builds with
 * hidapi.
 */
#ifndef PidKind_h
#define PidKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetPidKind();

} // namespace VolumeHaptics

#endif
