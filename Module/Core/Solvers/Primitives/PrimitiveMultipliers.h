// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The balance of primitives where it is not known what holds and what yields.
 *
 * Sweeps over the dual problem (PrimitiveSolver.h) are slow where directions depend on each other:
 * more planes than the space has dimensions, of which two and two are opposed, pass their forces to
 * each other by little in each. The method of multipliers sees all at once. With l_i the forces
 * that are known, b_i and w as in PrimitiveNewton.h, and P_i the nearest force that primitive i can
 * have, w is where
 *
 *   w = sum P_i(u_i),   u_i = l_i - m (b_i + w).
 *
 * The left side less the right one is the slope of a strongly convex function of w,
 * |w|^2 / 2 + sum h_i(u_i) / m with h_i(u) = (|u|^2 - |u - P_i(u)|^2) / 2, whatever depends on
 * what: so Newton's steps with a line search end, with three unknowns. Then l_i = P_i(u_i), and
 * again until nothing changes. That is the proximal point method in the dual (Rockafellar,
 * Augmented Lagrangians and applications of the proximal point algorithm, 1976): it always
 * converges, for planes alone in a finite number of rounds.
 */
#ifndef PrimitiveMultipliers_h
#define PrimitiveMultipliers_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

namespace VolumeHaptics
{

/**
 * From forces that are within the strengths. They stay so, and come nearer to those of a balance.
 *
 * @param isSettled whether they are those, but for rounding
 * @return how many places it has looked at, each of which takes about as long as a sweep
 */
int FindBalanceByMultipliers(
  const HeldPrimitives& held, int mostLooks, PrimitiveForces& forces, bool& isSettled) noexcept;

} // namespace VolumeHaptics

#endif
