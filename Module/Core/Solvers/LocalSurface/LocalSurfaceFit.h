// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fits a plane or a quadric to the isosurface near the proxy, for the slow loop of
 * HapticMethod::LocalSurface.
 *
 * The search looks for the nearest crossing of V = HapticSettings::IsoValue along 26 directions, up
 * to LocalReach voxels away, and along the tip's path. From the crossing it follows the gradient to
 * the foot of the perpendicular. Let c be the foot, N the unit normal (into the structure) and, for
 * a quadric, S the change of N along the surface at c. Then the depth of x is
 *
 *   depth(x) = N.u + u.S u / 2,   u = x - c,   S N = 0.
 *
 * A surface holds only from outside: a hand that has entered the structure without passing through
 * a nearby surface gets no surface. N is the normal from the gradient kernel, turned to the side on
 * which V rises or falls.
 *
 * All quantities are in world units, so that surfaces stay in place if the device's placement
 * changes.
 */
#ifndef LocalSurfaceFit_h
#define LocalSurfaceFit_h

#include "Core/State/LocalState.h"

namespace VolumeHaptics
{
class HapticModel;

/** Reach of the search around the hand (voxels along each axis). */
constexpr int LocalReach = 4;
/** Distance (voxels) from the centre of the searched cube to its corners: sqrt(3) LocalReach. */
constexpr double LocalCornerReach = 1.7320508075688772 * LocalReach;
/** Largest reach of the search ahead of the hand (voxels). */
constexpr int LocalReachAhead = 64;

/**
 * Fits a surface for a request. This takes 10 to 20 microseconds with kernels of 2 voxels, and 200
 * with kernels of 8. Equal requests have equal results, whatever the placement of the device.
 */
LocalSurface FitLocalSurface(const HapticModel& model, const LocalSurfaceRequest& request) noexcept;

} // namespace VolumeHaptics

#endif
