// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the balance of a proxy between a set of primitives and the spring to the tip.
 *
 *   PrimitiveSet set;
 *   set.Add({ PrimitiveKind::Line, flow, proxy, 2.0 });
 *   const PrimitiveBalance balance = Minimise(set, stiffness, tip, state.Forces);
 *
 * Let y be the tip, k the stiffness and phi_i the potentials of Primitive.h. Then the proxy x and
 * the force f on the hand are
 *
 *   x = argmin k/2 |x - y|^2 + sum phi_i(x),   f = k (x - y) = sum l_i.
 *
 * There is always exactly one solution. It is a proximal map: the proxy moves at most as far as the
 * tip, the force changes by at most k times that, and |f| is at most the sum of the strengths.
 *
 * ## Composition
 *
 * If all anchors are the same point, there is at most one line direction, and all directions of
 * lines and planes are parallel or orthogonal to each other, x is the composition of the single
 * solutions: forces first, then planes, then lines, then points. The prox of s|.| after the prox of
 * a positively homogeneous convex function is the prox of the sum, and orthogonal planes do not
 * interact.
 *
 * "Parallel" and "orthogonal" are up to DirectionTolerance, which is the rounding of unit vectors.
 * Let directions be off by an angle of e. From the variational inequalities of both problems, with
 * g = k (x - c), the forces differ by at most sqrt(e (|g| + |g'|) sum s_i): that is 5e-7 N for 5 N
 * of spring and strengths of 2 N. In the tests it is less than 1e-13 N.
 *
 * ## Descent
 *
 * Otherwise the dual problem is solved, one block after the other:
 *
 *   l_i = -(projection of k (y - c_i) + sum_{j != i} l_j onto C_i)
 *
 * with C_i the ball of s for a point, the disc across q for a line, and the segment from 0 to s q
 * for a plane. It begins with the forces of the last tick. Where the proxy yields a little at a
 * time, or directions are almost parallel, sweeps alone take long; so Anderson's acceleration mixes
 * the last four, if that does not raise the dual energy. All l_i are in C_i at any time: even if
 * the sweeps are spent, no force exceeds the strengths, and the next tick goes on. Once it is known
 * which primitives yield, PrimitiveRay.h or PrimitiveNewton.h ends the descent: mostly before the
 * first sweep, since the same primitives yielded in the last tick, else after one or a few sweeps.
 * Where directions depend on each other, such as those of opposed planes, sweeps may not show this;
 * after some of them, PrimitiveMultipliers.h does.
 */
#ifndef PrimitiveSolver_h
#define PrimitiveSolver_h

#include "Core/Solvers/Primitives/Primitive.h"

namespace VolumeHaptics
{

struct PrimitiveBalance
{
  Vector3 Proxy;             ///< in m
  Vector3 Force;             ///< force on the hand (N)
  int Sweeps = 0;            ///< number of sweeps, including the evaluations of the multipliers
  bool IsUnfinished = false; ///< whether the descent used all its sweeps without converging
};

namespace PrimitiveSolver
{
/** Largest sine or cosine of an angle between two directions that counts as 0. */
constexpr double DirectionTolerance = 4e-15;
constexpr int MostSweeps = 256;

/**
 * Computes the balance in closed form (Composition, above). Returns false and writes nothing if the
 * set does not allow it. The caller must have checked the numbers as Minimise does.
 */
bool Compose(const PrimitiveSet& set, double k, const Vector3& tip, PrimitiveForces& forces,
  PrimitiveBalance& balance) noexcept;

/**
 * Computes the balance of any set by descent, beginning with `forces`. The caller must have checked
 * the numbers as Minimise does.
 */
void Descend(const PrimitiveSet& set, double k, const Vector3& tip, PrimitiveForces& forces,
  PrimitiveBalance& balance, int mostSweeps = MostSweeps, const Vector3& towards = {}) noexcept;
} // namespace PrimitiveSolver

/**
 * Computes the balance at a tip (m), with a spring of stiffness k (N/m).
 *
 * @param forces receives the forces of this tick. Initially it has the forces of the last tick,
 * with which the descent begins; forces that are not finite are ignored
 * @param towards expected direction of the proxy as seen from a common anchor, of any length; 0 if
 * it is not known. It only affects the speed
 *
 * If the tip is not finite, if it is farther away than an anchor may be, or if k is not a positive
 * number, nothing holds, and the proxy is at the tip.
 */
PrimitiveBalance Minimise(const PrimitiveSet& set, double k, const Vector3& tip,
  PrimitiveForces& forces, int mostSweeps = PrimitiveSolver::MostSweeps,
  const Vector3& towards = {}) noexcept;

} // namespace VolumeHaptics

#endif
