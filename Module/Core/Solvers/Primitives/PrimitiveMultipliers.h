// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The balance of primitives if it is not known which hold and which yield.
 *
 * Sweeps over the dual problem (PrimitiveSolver.h) are slow where directions depend on each other:
 * more planes than the space has dimensions, in opposed pairs, pass only little of their forces to
 * each other in each sweep. The method of multipliers handles all at once. With l_i the known
 * forces, b_i and w as in PrimitiveNewton.h, and P_i the projection onto the forces that primitive
 * i can have, w solves
 *
 *   w = sum P_i(u_i),   u_i = l_i - m (b_i + w).
 *
 * The left side minus the right one is the slope of a strongly convex function of w, |w|^2 / 2 +
 * sum h_i(u_i) / m with h_i(u) = (|u|^2 - |u - P_i(u)|^2) / 2, for any dependence of directions: so
 * Newton's method with a line search converges, with three unknowns. Then l_i = P_i(u_i), and so on
 * until nothing changes. This is the proximal point method in the dual (Rockafellar, Augmented
 * Lagrangians and applications of the proximal point algorithm, 1976): it always converges, for
 * planes alone in a finite number of rounds.
 */
#ifndef PrimitiveMultipliers_h
#define PrimitiveMultipliers_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

namespace VolumeHaptics
{

/**
 * Computes a balance. The forces must be within the strengths. They stay within the strengths and
 * approach the forces of a balance. Returns the number of evaluated places, each of which takes
 * about as long as a sweep.
 * @param isSettled receives whether the forces are those of a balance, apart from rounding
 */
int SolveBalanceByMultipliers(
  const HeldPrimitives& held, int mostLooks, PrimitiveForces& forces, bool& isSettled) noexcept;

} // namespace VolumeHaptics

#endif
