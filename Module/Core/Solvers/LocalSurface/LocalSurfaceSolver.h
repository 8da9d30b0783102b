// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The servo's side of HapticMethod::LocalSurface: a surface that a slow loop renews.
 *
 * After Mark et al., "Adding Force Feedback to Graphics Systems", 1996. The place x of the proxy is
 * on the surface depth(x) = 0 (LocalSurface.h) and nearest to the tip there, as far as friction
 * lets it: where x_tip - x makes an angle of atan(mu) with the surface's normal at x, it sticks.
 * With the material at HapticSettings::IsoValue the force is k (x - x_tip); the surface holds
 * without limit, and there is no drag.
 *
 * Every 1 / LocalSurfaceRate a question goes out, and the answer to the last one comes in: another
 * surface, or none. By what x - x_tip changes then, and wherever else it changes by more than twice
 * the tip's motion (surfaces that bend more tightly than the hand is deep have several nearest
 * points), the hand feels later: the difference fades over RecoveryTime. So a surface that comes up
 * under the hand lifts it gently, and none lets go at once; and a difference never pulls the hand
 * in.
 *
 * One surface is known at a time. What the hand meets before the slow loop has seen it, it falls
 * through. A plane lags behind a curved surface that the hand slides over, and then spends energy
 * where that is convex, and gives some where it is concave.
 */
#ifndef LocalSurfaceSolver_h
#define LocalSurfaceSolver_h

#include "Core/Solvers/LocalSurface/LocalSurface.h"

namespace VolumeHaptics
{
struct LocalState;
struct ServoState;
struct TickRecord;

/** Where surfaces come from. */
struct LocalAnswer
{
  /** The tick finds the surface itself, as late as a slow loop of LocalSurfaceRate would. */
  static LocalAnswer Simulated() noexcept { return { true, nullptr }; }

  bool IsSimulated = false;
  const LocalSurface* Surface = nullptr; ///< to state.Local.Asked; null where it is still to come
};

/** One tick from record.Tip; writes all of the record. */
void StepLocalSurface(const HapticModel& model, ServoState& state, TickRecord& record,
  const LocalAnswer& answer) noexcept;

/** Forgets all surfaces, and asks for one near a place, for a tip, both in the world. */
void StartLocalSurface(const Vector3& where, const Vector3& tip, LocalState& local) noexcept;

} // namespace VolumeHaptics

#endif
