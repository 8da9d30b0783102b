// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the exact balance of primitives with a common anchor. This is the usual case, because
 * all modes are read at one place.
 *
 * Their potentials are homogeneous about the anchor, so only the direction d in which the proxy
 * leaves the anchor is unknown. Let b be the spring's force at the anchor and F(d) the sum of the
 * yielding forces, which does not depend on the distance. Then the best place on a ray is at rho =
 * d.(b + F), and d is the direction for which b + F has no component across d. Newton's method on
 * the sphere computes it, in two or three steps from the proxy's last direction.
 *
 * - A plane on which the proxy slides restricts d to a circle; the plane's force is the missing
 *   component along its normal. A line that holds, or two such planes, determine d completely.
 * - If rho is negative, all primitives hold at the anchor. Their forces are then not unique. The
 *   forces that yield together on a ray are used, multiplied by the fraction d.b / (-d.F) < 1.
 *
 * Unlike the steps of PrimitiveNewton.h, these steps are as good near the anchor as far from it:
 * near the anchor the forces change fast with the place, but not with the direction. This matters,
 * because the proxy of a tick ends where its primitives are read, so it may come arbitrarily close
 * to the anchor.
 */
#ifndef PrimitiveRay_h
#define PrimitiveRay_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

namespace VolumeHaptics
{

/**
 * Like SolveExactBalance() for the usual case. Also returns false if the anchors differ, or if more
 * than two planes or one line hold.
 *
 * @param towards expected direction from the anchor to the proxy, of any length; 0 if it is not
 * known
 */
bool SolveBalanceOnRay(const HeldPrimitives& held, const Vector3& towards, bool isOld,
  PrimitiveForces& forces, Vector3& sum) noexcept;

} // namespace VolumeHaptics

#endif
