// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a device does and feels, in words.
 */
#ifndef DisplayText_h
#define DisplayText_h

#include <string>

class vtkHapticDevice;

namespace VolumeHaptics
{

/**
 * The first sentence of a running device's status, or of a fault and of a request to the hand two
 * lines. Empty for a virtual device that only runs.
 */
std::string DescribeStatus(vtkHapticDevice* device);

/**
 * Such as "Resting on skin, 0.62 N of at most 10 N"; empty while nothing is touched. The tissue may
 * be empty. Of an inserted needle, such as "Needle 12.3 deep in fat, 0.62 N of at most 10 N";
 * its depth is in world units. Where modes are felt, none of which is a surface, nothing is rested
 * on: "Held, 0.62 N".
 */
std::string DescribeTouch(vtkHapticDevice* device, const std::string& tissue);

/** Whether the faces of a cut hold; empty if nothing is cut away. */
std::string DescribeCut(vtkHapticDevice* device);

/** The value in the surface, if there is one, and how the servo keeps time. */
std::string DescribeDetails(vtkHapticDevice* device);

} // namespace VolumeHaptics

#endif
