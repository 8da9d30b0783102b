// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Names of the arrays that only traces of tools have.
 */
#ifndef ToolColumns_h
#define ToolColumns_h

namespace VolumeHaptics
{

constexpr const char* ToolColumns[] = { "Orientation", "Torque", "Depth", "ShaftForce",
  "ToolOrientation", "RemovedVolume", "ForbiddenTouches" };

} // namespace VolumeHaptics

#endif
