// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the exact balance of primitives if it is known which of them hold and which yield.
 *
 * Let w be the sum of their forces and b_i = k (y - c_i) plus the pushes, with all lengths in
 * newtons. Then the balance is the minimum of |w|^2 / 2 + sum phi_i(b_i + w) over w, which are only
 * three numbers. Each primitive either
 *
 * - holds: b_i + w is on its line, plane or point, which is a linear condition, and its force is a
 *   multiplier within its strength;
 * - yields: its force has the magnitude of its strength, and phi_i is smooth; or
 * - is a plane that the proxy has left: its force is 0.
 *
 * If the states are known, Newton's method with the conditions of the holding primitives computes
 * w: in one step if no line or point yields, and in a few otherwise. The directions of the yielding
 * forces are unknowns in addition to w, so that a few steps suffice even if these primitives yield
 * only a little. Assumptions that the result contradicts are corrected, a few times; only a result
 * that contradicts none of them is used.
 *
 * More than three conditions can be fulfilled only if all primitives that hold have the same
 * anchor. Then w is known, but the forces that add up to it are not unique. Forces s_i P_i m, where
 * P_i is the projection onto the directions in which primitive i holds, distribute it according to
 * the strengths.
 */
#ifndef PrimitiveNewton_h
#define PrimitiveNewton_h

#include "Core/Solvers/Primitives/PrimitiveSolver.h"

namespace VolumeHaptics
{

/** The primitives of a set that have a strength and are not pushes, and the b_i of each. */
struct HeldPrimitives
{
  const PrimitiveSet& Set;
  const int* Number; ///< number of each primitive in the set
  const Vector3* Spring;
  int Count;
};

/**
 * Computes the exact balance. The given forces must be within the strengths, and so close to those
 * of the balance that they show which primitives hold and which yield. If so, makes the forces and
 * their sum exact and returns true. If not, writes nothing and returns false.
 *
 * @param isOld whether the forces come from another tick. Forces near the full strength then count
 * as full
 */
bool SolveExactBalance(
  const HeldPrimitives& held, bool isOld, PrimitiveForces& forces, Vector3& sum) noexcept;

} // namespace VolumeHaptics

#endif
