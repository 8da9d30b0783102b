// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes gamepads, "vibration:pad" and "vibration:pad:N", which vibrate but exert no
 * force.
 */
#ifndef PadKind_h
#define PadKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetPadKind();

} // namespace VolumeHaptics

#endif
