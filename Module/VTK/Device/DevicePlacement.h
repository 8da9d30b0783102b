// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the placement of a device in the world from points that its stylus touched.
 */
#ifndef DevicePlacement_h
#define DevicePlacement_h

#include <string>

class vtkMatrix4x4;
class vtkPoints;

namespace VolumeHaptics
{

/**
 * Computes the matrix that maps touched positions to known ones by least squares, and the largest
 * residual distance. Returns the fault, with its cure, if the points do not determine the
 * placement; empty on success. See vtkHapticDevice::FitDeviceToWorld.
 */
std::string ComputePlacement(vtkPoints* touched, vtkPoints* known, double scale,
  vtkMatrix4x4* deviceToWorld, double& largestDistance);

} // namespace VolumeHaptics

#endif
