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

///@{
/**
 * Each where its library was found when this one was built; else nothing is listed, and Make says
 * so.
 */
DeviceKind GetFalconKind();
DeviceKind GetWoodenKind();
DeviceKind GetPidKind();
DeviceKind GetSpaceMouseKind();
///@}

/** All of them. */
std::vector<DeviceKind> GetBuiltInKinds();

} // namespace VolumeHaptics

#endif
