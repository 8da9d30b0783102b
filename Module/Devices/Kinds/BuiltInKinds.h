// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kinds of devices that come with this library.
 */
#ifndef BuiltInKinds_h
#define BuiltInKinds_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

/**
 * All of them. A kind whose library is missing from this build lists nothing, and its Make says so.
 */
std::vector<DeviceKind> GetBuiltInKinds();

} // namespace VolumeHaptics

#endif
