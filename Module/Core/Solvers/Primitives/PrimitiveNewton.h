// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The exact balance of primitives, once it is known which of them hold and which yield.
 *
 * With w the sum of their forces, b_i = k (y - c_i) and the pushes, and all lengths in newtons, the
 * balance is the minimum of |w|^2 / 2 + sum phi_i(b_i + w) over w alone: three numbers. Each
 * primitive either
 *
 * - holds: b_i + w is on its line, plane or point, a linear condition, and its force is a
 *   multiplier within its strength;
 * - yields: its force is its strength, and phi_i is smooth; or
 * - is a plane that is left: its force is 0.
 *
 * If the states are known, Newton's method with the conditions of the holding primitives computes
 * w: in one step if no line or point yields, and in a few otherwise. The directions of the yielding
 * forces are unknowns in addition to w: so it also ends in a few steps if they yield by little.
 * Assumptions that the result contradicts are corrected, a few times; a result counts only if it
 * contradicts none.
 *
 * More than three conditions are met only if all primitives that hold have one anchor. Then w is
 * known, and forces that add up to it are not unique. Forces s_i P_i m, with P_i the projection
 * onto the directions in which primitive i holds, share it by strength.
 */
#ifndef PrimitiveNewton_h
#define PrimitiveNewton_h

#include "Core/Solvers/Primitives/PrimitiveSolver.h"

namespace VolumeHaptics
{

/** The primitives of a set that have a strength and are not pushes, and b_i of each. */
struct HeldPrimitives
{
  const PrimitiveSet& Set;
  const int* Number; ///< number of each primitive in the set
  const Vector3* Spring;
  int Count;
};

/**
 * Computes the exact balance. The given forces must be within the strengths, and must be so close
 * to those of the balance that they show which primitives hold and which yield. If they do, makes
 * the forces and their sum exact and returns true; otherwise writes nothing and returns false.
 *
 * @param isOld whether the forces are from another tick, where nearly the whole strength counts as
 * all of it
 */
bool SolveExactBalance(
  const HeldPrimitives& held, bool isOld, PrimitiveForces& forces, Vector3& sum) noexcept;

} // namespace VolumeHaptics

#endif
