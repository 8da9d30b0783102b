// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Expresses the material law of MaterialLaw.h by primitives.
 *
 * Let N be the normal into the structure, and F = k (y - c) the spring's force:
 *
 *   PLANE  -N, T_N W_d     eq. 12: the surface
 *   LINE   N,  mu f_N      eqs. 8 to 10: friction, with f_N the force that the plane takes of F
 *   POINT  R               eq. 14: the drag
 *
 * Their composition in this order equals the paper's order of steps. For surfaces, the solvers
 * still use the law, because it needs no set of primitives. The tests compare both.
 */
#ifndef MaterialPrimitives_h
#define MaterialPrimitives_h

#include "Core/Law/MaterialPoint.h"
#include "Core/Solvers/Primitives/Primitive.h"

#include <algorithm>

namespace VolumeHaptics
{

/**
 * Adds the surface, friction and drag of a material point. The spring has the stiffness k (N/m) and
 * leads from `anchor` to `tip`.
 */
inline void AddMaterial(const MaterialPoint& point, double k, const Vector3& anchor,
  const Vector3& tip, PrimitiveSet& set) noexcept
{
  const double push = k * Dot(tip - anchor, point.Normal);
  const double normalForce = std::clamp(push, 0.0, std::max(point.SurfaceStrength, 0.0));
  set.Add({ PrimitiveKind::Plane, -point.Normal, anchor, point.SurfaceStrength });
  set.Add({ PrimitiveKind::Line, point.Normal, anchor, point.Friction * normalForce });
  set.Add({ PrimitiveKind::Point, {}, anchor, point.Viscosity });
}

} // namespace VolumeHaptics

#endif
