// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes Haply's Inverse3, Inverse3x and Minverse, "haply[:ID]", in builds with
 * Boost.Beast.
 */
#ifndef HaplyKind_h
#define HaplyKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetHaplyKind();

} // namespace VolumeHaptics

#endif
