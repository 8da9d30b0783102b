// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes the shapes on which modes hold the hand, as polydata in world coordinates.
 */
#ifndef FollowedPolyData_h
#define FollowedPolyData_h

class vtkPolyData;

namespace VolumeHaptics
{
class HapticModel;
struct Vector3;

/** Replaces the contents of `shapes`: see vtkHapticState::GetFollowed. The proxy is in metres. */
void WriteFollowed(
  const HapticModel& model, const Vector3& proxy, double reach, vtkPolyData* shapes);

} // namespace VolumeHaptics

#endif
