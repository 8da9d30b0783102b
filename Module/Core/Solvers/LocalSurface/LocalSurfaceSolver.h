// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The servo's side of HapticMethod::LocalSurface: touches a surface that a slow loop renews.
 *
 * After Mark et al., "Adding Force Feedback to Graphics Systems", 1996. The proxy x is the point of
 * the surface depth(x) = 0 (LocalSurfaceFit.h) that is nearest to the tip, as far as friction
 * allows: it sticks while x_tip - x makes an angle of less than atan(mu) with the surface's normal
 * at x. With the material at HapticSettings::IsoValue the force is k (x - x_tip). The surface holds
 * without limit, and there is no drag.
 *
 * Every 1 / LocalSurfaceRate a request goes out and the last request's result comes in: a new
 * surface, or none. The lag then jumps, as it also does if several points of a tightly bent surface
 * are nearest to the tip. A change of more than twice the tip's motion is such a jump: the felt
 * force fades into it over RecoveryTime. So a surface that comes up under the hand lifts it gently,
 * no surface lets go at once, and a jump never pulls the hand in.
 *
 * If the volume moves, the surface goes along with it in every tick, by the level at its centre,
 * and with the material if displacements are known; the proxy that it holds goes along.
 *
 * One surface is known at a time. The hand falls through surfaces that it meets before the slow
 * loop has found them. A plane lags behind a curved surface that the hand slides over: it then
 * takes energy from the hand if the surface is convex, and gives some if it is concave.
 */
#ifndef LocalSurfaceSolver_h
#define LocalSurfaceSolver_h

#include "Core/Solvers/LocalSurface/LocalSurfaceFit.h"
#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{
struct LocalState;

/** The result of the slow loop for a tick. */
struct LocalSurfaceResult
{
  /**
   * Returns a result for which the tick computes the surface itself, as late as a slow loop of
   * LocalSurfaceRate would deliver it.
   */
  static LocalSurfaceResult Simulated() noexcept { return { true, nullptr }; }

  bool IsSimulated = false;
  const LocalSurface* Surface = nullptr; ///< the answer to state.Local.Request; null until it has
                                         ///< come
};

/** Computes one tick from record.Tip; writes all of the record. */
void StepLocalSurface(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept;

/** See Method::Reach. */
Vector3 FindLocalSurfaceReach(const HapticModel& model) noexcept;
/** See Method::Include. */
void IncludeLocalSurface(const HapticModel& model, const ServoState& state, ReadBox& box) noexcept;

/**
 * Drops all surfaces, and requests a surface near a position, for a tip; both positions are in the
 * world.
 */
void StartLocalSurface(const Vector3& position, const Vector3& tip, LocalState& local) noexcept;

} // namespace VolumeHaptics

#endif
