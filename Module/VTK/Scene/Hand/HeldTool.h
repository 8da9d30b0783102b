// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Looks up the tool in a hand, for the scene.
 */
#ifndef HeldTool_h
#define HeldTool_h

class vtkHapticDevice;
class vtkHapticTool;

namespace VolumeHaptics
{

/** Returns the tool in the hand of a device; null if the hand touches with a point. */
vtkHapticTool* GetHeldTool(vtkHapticDevice* device);

/** Whether a tool looks different when it is turned. */
bool IsTurnable(vtkHapticTool* tool);

/**
 * Returns the distance (world units) from the hand to the farthest touching point of a tool; 0
 * without a shape.
 */
double ComputeToolReach(vtkHapticTool* tool);

} // namespace VolumeHaptics

#endif
