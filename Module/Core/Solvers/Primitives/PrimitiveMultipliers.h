// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the balance of primitives if it is not known which of them hold and which yield.
 *
 * Sweeps over the dual problem (PrimitiveSolver.h) are slow where directions depend on each other:
 * if there are more planes than dimensions, in opposed pairs, each sweep passes only little of
 * their forces from one to another. The method of multipliers treats all primitives at once. With
 * the known forces l_i, with b_i and w as in PrimitiveNewton.h, and with P_i the projection onto
 * the possible forces of primitive i, w solves
 *
 *   w = sum P_i(u_i),   u_i = l_i - m (b_i + w).
 *
 * The left side minus the right one is the slope of a strongly convex function of w, |w|^2 / 2 +
 * sum h_i(u_i) / m with h_i(u) = (|u|^2 - |u - P_i(u)|^2) / 2, for any dependence of directions.
 * Newton's method with a line search therefore converges, with three unknowns. Then l_i = P_i(u_i),
 * and the next round begins, until nothing changes. This is the proximal point method in the dual
 * (Rockafellar, Augmented Lagrangians and applications of the proximal point algorithm, 1976). It
 * always converges, and for planes alone in a finite number of rounds.
 */
#ifndef PrimitiveMultipliers_h
#define PrimitiveMultipliers_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

namespace VolumeHaptics
{

/**
 * Computes a balance. The forces must be within the strengths. They remain within the strengths and
 * approach the forces of a balance. Returns the number of evaluated places; each takes about as
 * long as a sweep.
 * @param isSettled receives whether the forces are in balance, apart from rounding
 */
int SolveBalanceByMultipliers(
  const HeldPrimitives& held, int mostLooks, PrimitiveForces& forces, bool& isSettled) noexcept;

} // namespace VolumeHaptics

#endif
