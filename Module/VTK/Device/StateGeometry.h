// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts a device's state to geometry, and the shapes that modes hold the hand on. The state
 * comes from a device or from a client's message.
 */
#ifndef StateGeometry_h
#define StateGeometry_h

#include "vtkVector.h"              // for vtkVector3d
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkPolyData;

namespace VolumeHaptics
{

/** State to show: positions in world units, forces in N along the world's axes. */
struct ShownState
{
  vtkVector3d Tip;
  vtkVector3d Proxy;
  vtkVector3d SurfacePosition;
  vtkVector3d MediumPosition;
  vtkVector3d Force;
  vtkVector3d ComputedForce;
  vtkVector3d Normal;
  double NormalForce = 0.0;
  double FrictionForce = 0.0;
  double Contact = 0.0;
  double SurfaceValue = 0.0;
  double Orientation[4] = {}; ///< w, x, y, z; all 0 without an orientation
};

/** Replaces the output with the geometry that vtkHapticState::CopyToPolyData describes. */
VTKVOLUMEHAPTICS_EXPORT void WriteStateGeometry(
  const ShownState& state, double forceScale, bool isCommanded, vtkPolyData* output);

class HapticModel;
struct Vector3;

/** Replaces the contents of `shapes`: see vtkHapticState::GetFollowed. The proxy is in metres. */
void WriteFollowed(
  const HapticModel& model, const Vector3& proxy, double reach, vtkPolyData* shapes);

} // namespace VolumeHaptics

#endif
