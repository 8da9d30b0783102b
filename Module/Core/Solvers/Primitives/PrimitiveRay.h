// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The exact balance of primitives that have one anchor: the usual case, since all modes are read at
 * one place.
 *
 * Their potentials are homogeneous about the anchor, so only the direction d in which the proxy
 * leaves the anchor is unknown. With b the spring's force at the anchor and F(d) the sum of the
 * yielding forces, which does not depend on the distance, the best place on a ray is at rho = d.(b
 * + F), and d is the direction in which b + F has no part across it. Newton's method on the sphere
 * computes it, in two or three steps from the direction in which the proxy was last.
 *
 * - A plane on which the proxy slides restricts d to a circle; the plane's force is the missing
 *   part along its normal. A line that holds, or two such planes, leave no choice of d.
 * - If rho is negative, all primitives hold at the anchor. Their forces are not unique then: the
 *   forces that yield together on a ray are taken, times the needed fraction d.b / (-d.F) < 1.
 *
 * Unlike the steps of PrimitiveNewton.h, these steps are as good near the anchor as far from it:
 * near the anchor the forces change fast with the place, but not with the direction. This matters,
 * because the proxy of a tick ends where its primitives are read, and so may come arbitrarily near
 * to the anchor.
 */
#ifndef PrimitiveRay_h
#define PrimitiveRay_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

namespace VolumeHaptics
{

/**
 * Does the same as SolveExactBalance in the usual case. Returns false, too, if the anchors differ,
 * or if more than two planes or one line hold.
 *
 * @param towards expected direction of the proxy as seen from the anchor, of any length; 0 if it is
 * not known
 */
bool SolveBalanceOnRay(const HeldPrimitives& held, const Vector3& towards, bool isOld,
  PrimitiveForces& forces, Vector3& sum) noexcept;

} // namespace VolumeHaptics

#endif
