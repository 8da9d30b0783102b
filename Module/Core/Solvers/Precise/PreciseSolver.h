// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The solver Precise: the paper's material law, in balance at the proxy's end point.
 *
 * Paper makes one explicit step with the material at the beginning of a tick's motion, whereas
 * Precise makes the law hold at the end of the motion.
 *
 * ## Equations
 *
 * The tip moves along a straight path in a tick. The rate-independent law of MaterialLaw.h then is
 *
 *   x' = 0                  while surface, friction and drag take the force F = k (x_tip - x),
 *   F  = q + R x'/|x'|      else, with q the force that surface and friction take at x,
 *
 * with the normal, the material and the thresholds at the proxy x.
 *
 * ## Method
 *
 * The tip moves in steps of a quarter of a voxel or 2 % of the lag. After each step, the proxy
 * moves until the law no longer moves it. A motion is that of Law::Move, at most a quarter of a
 * voxel long, and is checked at its end: if the material there holds more than the spring pulls,
 * the end is moved back to the point at which both are equal (regula falsi, along the normal and
 * perpendicular to it; at a step of a transfer function, bisection to a thousandth of a voxel, on
 * the side that holds). While a surface holds the proxy, the proxy stays on the level of the
 * estimator's own value at which it first touched the surface (a Newton step after each motion), so
 * that it does not drift. If friction or drag turn a motion, the mean of its first and last
 * direction is used (second order).
 *
 * A sliding hand repeats its motion from tick to tick, which saves most samples. The last sample is
 * stored until the proxy is 1e-3 voxels away from it (4e-3 if labels make the geometry). While a
 * surface holds, a tick's first motion is multiplied by the ratio that was found in the last ticks
 * (PreciseState::StepPrediction). A tick of a tenth of a voxel then needs one or two samples.
 * Stored sample and prediction only propose motions; the checks do not depend on them.
 *
 * ## Existence and uniqueness
 *
 * For one material point, a motion is unique: the drag's motion is the proximal map of R|m| after
 * the surface's proximal map. Both are convex; the law applies the normal part before friction,
 * which makes friction unique, too. Each accepted motion shortens the spring, and the solver finds
 * the first point at which the law holds.
 *
 * ## Work
 *
 * A tick uses at most MaximumLooks samples. If they are not enough (for a tip that moves tens of
 * voxels in a tick), the proxy stays at the point that it has reached, the force is that of the
 * earlier tip with which this proxy is in balance, and the next tick continues from there. The
 * force thus neither jumps nor exceeds the material's strength, and no point is skipped.
 * TickRecord::IsUnfinished is then set.
 */
#ifndef PreciseSolver_h
#define PreciseSolver_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Limit of the samples in a tick. */
constexpr int MaximumLooks = 256;

/**
 * Computes a tick for record.Tip. Writes the record and the state. The new proxy is only in
 * record.Proxy; Tick() copies it to state.Proxy.
 */
void StepPrecise(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept;

/** Implements Method::Reach. */
Vector3 FindPreciseReach(const HapticModel& model) noexcept;
/** Implements Method::Include. */
void IncludePrecise(const HapticModel& model, const ServoState& state, ReadBox& box) noexcept;

} // namespace VolumeHaptics

#endif
