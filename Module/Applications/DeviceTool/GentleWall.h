// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A wall through the middle of a device's workspace, soft enough for a first touch.
 */
#ifndef GentleWall_h
#define GentleWall_h

class vtkVolumeHapticsFilter;

/// Newtons on the hand, at most.
constexpr double GentleForce = 1.0;

/**
 * Makes the filter a wall across an axis (0 to 2): free on the positive side of the device's
 * middle, a smooth solid of 200 N/m on the negative side. One world unit is a millimetre of the
 * device.
 */
void MakeGentleWall(vtkVolumeHapticsFilter* filter, int axis);

#endif
