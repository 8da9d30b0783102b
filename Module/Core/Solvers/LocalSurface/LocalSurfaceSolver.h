// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The servo's part of HapticMethod::LocalSurface. The proxy touches a surface that a slow loop
 * renews.
 *
 * The method follows Mark et al., "Adding Force Feedback to Graphics Systems", 1996. The proxy x is
 * the point of the surface depth(x) = 0 (LocalSurfaceFit.h) that is nearest to the tip, unless
 * friction holds it: it sticks while x_tip - x makes an angle of less than atan(mu) with the
 * surface's normal at x. The material is the one at HapticSettings::IsoValue, and the force is k (x
 * - x_tip). The surface withstands any force, and there is no drag.
 *
 * After every 1 / LocalSurfaceRate, a new request is sent, and the result of the last one is
 * received: a new surface, or none. The lag then jumps. It also jumps if several points of a
 * tightly bent surface are nearest to the tip. A change of more than twice the tip's motion counts
 * as a jump: the felt force then changes to the new one gradually, over RecoveryTime. Thus a
 * surface that appears under the hand lifts it gently, a surface that disappears does not release
 * it at once, and a jump never pulls the hand in.
 *
 * If the volume moves, the surface moves with it in every tick: with the material if displacements
 * are known, and then to the level of its centre. The proxy on the surface moves with it.
 *
 * Only one surface is known at a time. The hand falls through a surface that it reaches before the
 * slow loop has found it. If the hand slides over a curved surface, the plane lags behind: it then
 * takes energy from the hand if the surface is convex, and gives some if it is concave.
 */
#ifndef LocalSurfaceSolver_h
#define LocalSurfaceSolver_h

#include "Core/Solvers/LocalSurface/LocalSurfaceFit.h"
#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{
struct LocalState;

/** The result of the slow loop, as passed to a tick. */
struct LocalSurfaceResult
{
  /**
   * Returns a result that makes the tick compute the surface itself, with the same delay as a slow
   * loop with LocalSurfaceRate.
   */
  static LocalSurfaceResult Simulated() noexcept { return { true, nullptr }; }

  bool IsSimulated = false;
  const LocalSurface* Surface = nullptr; ///< reply to state.Local.Request, or null
};

/** Computes a tick for record.Tip, and writes the whole record. */
void StepLocalSurface(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept;

/** Implements Method::Reach. */
Vector3 FindLocalSurfaceReach(const HapticModel& model) noexcept;
/** Implements Method::Include. */
void IncludeLocalSurface(const HapticModel& model, const ServoState& state, ReadBox& box) noexcept;

/**
 * Drops all surfaces, and requests a surface near a position. Position and tip are in the world.
 */
void StartLocalSurface(const Vector3& position, const Vector3& tip, LocalState& local) noexcept;

} // namespace VolumeHaptics

#endif
