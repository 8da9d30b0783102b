// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes arms with an hfab controller, "hfab:PORT", on systems with termios.
 */
#ifndef HfabKind_h
#define HfabKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetHfabKind();

} // namespace VolumeHaptics

#endif
