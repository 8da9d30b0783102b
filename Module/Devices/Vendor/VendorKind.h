// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes devices of vendors' libraries, "vendor:PLUGIN:N", on systems with dlopen.
 */
#ifndef VendorKind_h
#define VendorKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetVendorKind();

} // namespace VolumeHaptics

#endif
