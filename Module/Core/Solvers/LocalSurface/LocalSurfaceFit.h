// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fits a plane or a quadric to the isosurface near the proxy: the slow loop of
 * HapticMethod::LocalSurface.
 *
 * The search looks for the nearest crossing of V = HapticSettings::IsoValue along 26 directions,
 * LocalReach voxels far, and along the tip's path; from the crossing it follows the gradient to
 * the foot of the perpendicular. With the foot c, the unit normal N (into the structure) and, for a
 * quadric, the change S of N across c, the depth of x is
 *
 *   depth(x) = N.u + u.S u / 2,   u = x - c,   S N = 0.
 *
 * A surface holds from outside only: a hand that is in the structure without having come through a
 * nearby surface gets no surface. N is the normal of the gradient kernel, turned to the side on
 * which V rises or falls.
 *
 * Everything is in world units, so that surfaces stay in place when the device is placed again.
 */
#ifndef LocalSurfaceFit_h
#define LocalSurfaceFit_h

#include "Core/State/LocalState.h"

namespace VolumeHaptics
{
class HapticModel;

/** The search's reach around the hand (voxels along each axis). */
constexpr int LocalReach = 4;
/** The reach to a corner of the searched cube: sqrt(3) LocalReach. */
constexpr double LocalCornerReach = 1.7320508075688772 * LocalReach;
/** The search's largest reach ahead of the hand (voxels). */
constexpr int LocalReachAhead = 64;

/**
 * Fits a surface for a request. Takes 10 to 20 microseconds with kernels of 2 voxels, 200 with
 * kernels of 8. Equal requests get equal results, for any placement of the device.
 */
LocalSurface FitLocalSurface(const HapticModel& model, const LocalSurfaceRequest& request) noexcept;

} // namespace VolumeHaptics

#endif
