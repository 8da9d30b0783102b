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
 * tip, the force changes by at most k times this distance, and |f| is at most the sum of the
 * strengths.
 *
 * ## Composition
 *
 * If all anchors coincide, if there is at most one line direction, and if all directions of lines
 * and planes are parallel or orthogonal to each other, x is the composition of the single
 * solutions: forces first, then planes, then lines, then points. The reason is that the prox of
 * s|.| after the prox of a positively homogeneous convex function is the prox of the sum, and that
 * orthogonal planes do not interact.
 *
 * "Parallel" and "orthogonal" hold up to DirectionTolerance, which is the rounding of unit vectors.
 * Let directions be off by an angle of e. From the variational inequalities of both problems, with
 * g = k (x - c), the forces differ by at most sqrt(e (|g| + |g'|) sum s_i), which is 5e-7 N for a
 * spring force of 5 N and strengths of 2 N. In the tests it is less than 1e-13 N.
 *
 * ## Descent
 *
 * In all other cases, the dual problem is solved, one block after the other:
 *
 *   l_i = -(projection of k (y - c_i) + sum_{j != i} l_j onto C_i)
 *
 * where C_i is the ball of radius s for a point, the disc across q for a line, and the segment from
 * 0 to s q for a plane. The descent begins with the forces of the last tick. Sweeps alone take long
 * where the proxy yields slowly, or where directions are almost parallel. Anderson's acceleration
 * therefore mixes the last four sweeps, if this does not raise the dual energy. All l_i are in C_i
 * at any time: even if the sweeps are used up, no force exceeds the strengths, and the next tick
 * continues. As soon as it is known which primitives yield, PrimitiveRay.h or PrimitiveNewton.h
 * completes the descent. Usually this happens before the first sweep, because the same primitives
 * yielded in the last tick, and otherwise after one or a few sweeps. If directions depend on each
 * other, such as those of opposed planes, sweeps may not show which primitives yield; after some
 * sweeps, PrimitiveMultipliers.h determines it.
 */
#ifndef PrimitiveSolver_h
#define PrimitiveSolver_h

#include "Core/Solvers/Primitives/Primitive.h"

namespace VolumeHaptics
{

struct PrimitiveBalance
{
  Vector3 Proxy;             ///< position (m)
  Vector3 Force;             ///< force on the hand (N)
  int Sweeps = 0;            ///< number of sweeps, including the evaluations of the multipliers
  bool IsUnfinished = false; ///< whether the descent used all its sweeps without converging
};

namespace PrimitiveSolver
{
/** A sine or cosine of the angle between two directions counts as 0 up to this limit. */
constexpr double DirectionTolerance = 4e-15;
constexpr int MostSweeps = 256;

/**
 * Computes the balance in closed form (see Composition). Returns false and writes nothing if the
 * set does not allow it. The caller must have checked the numbers as Minimise() does.
 */
bool Compose(const PrimitiveSet& set, double k, const Vector3& tip, PrimitiveForces& forces,
  PrimitiveBalance& balance) noexcept;

/**
 * Computes the balance of any set by descent, beginning with `forces`. The caller must have checked
 * the numbers as Minimise() does.
 */
void Descend(const PrimitiveSet& set, double k, const Vector3& tip, PrimitiveForces& forces,
  PrimitiveBalance& balance, int mostSweeps = MostSweeps, const Vector3& towards = {}) noexcept;
} // namespace PrimitiveSolver

/**
 * Computes the balance at a tip (m), with a spring of stiffness k (N/m).
 *
 * @param forces receives the forces of this tick. On input, it contains the forces of the last
 * tick, with which the descent begins; forces that are not finite are ignored
 * @param towards expected direction from a common anchor to the proxy, of any length; 0 if it is
 * not known. It only affects the speed
 *
 * If the tip is not finite or farther away than an anchor may be, or if k is not a positive number,
 * nothing holds, and the proxy is at the tip.
 */
PrimitiveBalance Minimise(const PrimitiveSet& set, double k, const Vector3& tip,
  PrimitiveForces& forces, int mostSweeps = PrimitiveSolver::MostSweeps,
  const Vector3& towards = {}) noexcept;

} // namespace VolumeHaptics

#endif
