// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes 3Dconnexion's six-axis mice, "spacemouse:N", in builds with hidapi.
 */
#ifndef SpaceMouseKind_h
#define SpaceMouseKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetSpaceMouseKind();

} // namespace VolumeHaptics

#endif
