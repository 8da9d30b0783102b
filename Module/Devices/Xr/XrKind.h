// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Controllers of headsets, "vibration:xr". Vibration, not force.
 *
 * The back end needs no library: it opens whether or not a program can reach a headset. This kind
 * says what a program needs for that, since the user looks for it in the list of devices.
 */
#ifndef XrKind_h
#define XrKind_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

DeviceKind GetXrKind();

/**
 * Returns the file of the OpenXR runtime that OpenXR's loader uses on Linux: the one in
 * XR_RUNTIME_JSON, else openxr/1/active_runtime.json in the folders of XDG_CONFIG_HOME and
 * XDG_CONFIG_DIRS, or in /etc. Returns an empty path if there is none.
 */
std::string FindXrRuntime();

/**
 * Returns the missing part, and the cure; empty if nothing is missing. `hasModule` tells whether
 * this library was built with VTK's module RenderingOpenXR.
 */
std::string WhyNoXr(bool hasModule, const std::string& runtime);

} // namespace VolumeHaptics

#endif
