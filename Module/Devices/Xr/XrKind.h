// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists and makes controllers of headsets, "vibration:xr", which vibrate but exert no force.
 *
 * The back end needs no library, and opens even if the program can't access a headset. This kind
 * reports the requirements for that, because users look for them in the list of devices.
 */
#ifndef XrKind_h
#define XrKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetXrKind();

/**
 * Returns the file of the OpenXR runtime that OpenXR's loader uses on Linux: the value of
 * XR_RUNTIME_JSON, otherwise openxr/1/active_runtime.json in the folders of XDG_CONFIG_HOME and
 * XDG_CONFIG_DIRS, or in /etc. Returns an empty path if there is none.
 */
std::string FindXrRuntime();

/**
 * Returns the missing part and the cure; an empty text if nothing is missing. `hasModule`: whether
 * this library was built with VTK's module RenderingOpenXR.
 */
std::string WhyNoXr(bool hasModule, const std::string& runtime);

} // namespace VolumeHaptics

#endif
