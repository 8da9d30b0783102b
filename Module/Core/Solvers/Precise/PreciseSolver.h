// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Solver PRECISE: the paper's material law in balance where the proxy ends, not where it began.
 *
 * What is solved. Along the tip's straight way in a tick, the rate-independent law of
 * MaterialLaw.h,
 *
 *   x' = 0                                     while the spring's force F = k (x_tip - x) is taken,
 *   F  = q + R x'/|x'|,  q = what surface and friction take of F at x,         while it is not,
 *
 * with normal, material and thresholds of the place x where the proxy is. PAPER is one explicit
 * step of it.
 *
 * How. The tip goes in steps of a quarter of a voxel or 2 % of the spring; after each, the proxy
 * moves until the law leaves it in place. A motion is that of Law::Move, no longer than a quarter
 * of a voxel, and is judged at its end: where the place there holds more than the spring pulls, the
 * end is drawn back to where both are equal (regula falsi, along the normal and across it; at a
 * step of a transfer function, bisection to a thousandth of a voxel, on the side that holds). While
 * a surface holds, the proxy stays on the level of the estimator's own value that it met first (a
 * Newton step after each motion), so that nothing drifts. Where friction or drag turn the motion,
 * it takes the mean of its first and last direction (second order).
 *
 * A hand that slides does from tick to tick what it did before, which saves most of the looks: the
 * place where the last tick ended is kept until the proxy has strayed from it by 1e-3 voxels, and
 * where a surface holds, a tick's first motion is as much longer than what its beginning asks for
 * as the whole ways of the last ticks were. A tick of a tenth of a voxel then looks once or twice.
 * No judgement rests on what is kept: it only proposes motions.
 *
 * Existence and uniqueness. With the place frozen, a motion is unique: the drag's is the proximal
 * map of R|m| after that of the surface (both convex; the law takes normal before friction, which
 * makes it unique, too). Each accepted motion shortens the spring; what is found is the first place
 * on the way where the law holds.
 *
 * Work. A tick looks at MaximumLooks places at most. If that is not enough (a tip at tens of voxels
 * a tick), the proxy is where it came to, the force is that of a tip some way back, where this
 * proxy is in balance, and the next tick goes on from there: the force neither jumps nor exceeds
 * what the material can hold, nothing is skipped, and TickRecord::IsUnfinished says so.
 */
#ifndef PreciseSolver_h
#define PreciseSolver_h

namespace VolumeHaptics
{
class HapticModel;
struct ServoState;
struct TickRecord;

/** Places that a tick looks at, at most. */
constexpr int MaximumLooks = 256;

/** One tick from record.Tip; writes the record and all of the state but its proxy. */
void StepPrecise(const HapticModel& model, ServoState& state, TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
