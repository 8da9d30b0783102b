// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes Novint Falcons, "falcon:N", in builds with libusb.
 */
#ifndef FalconKind_h
#define FalconKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetFalconKind();

} // namespace VolumeHaptics

#endif
