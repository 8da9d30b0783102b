// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes WoodenHaptics, "wooden:N", in builds with hidapi.
 */
#ifndef WoodenKind_h
#define WoodenKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetWoodenKind();

} // namespace VolumeHaptics

#endif
