// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Determines the state of a primitive in a balance, given forces that are close to it.
 */
#ifndef PrimitiveHolds_h
#define PrimitiveHolds_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

inline Vector3 AtMost(const Vector3& force, double most) noexcept
{
  const double square = Dot(force, force);
  return square > most * most ? (most / std::sqrt(square)) * force : force;
}

/**
 * Returns the force nearest to `force` in C_i, the set of the primitive's possible forces.
 */
inline Vector3 Nearest(const Primitive& primitive, const Vector3& force) noexcept
{
  const double along = Dot(force, primitive.Direction);
  switch (primitive.Kind)
  {
    case PrimitiveKind::Point:
      return AtMost(force, primitive.Strength);
    case PrimitiveKind::Line:
      return AtMost(force - along * primitive.Direction, primitive.Strength);
    case PrimitiveKind::Plane:
      return std::clamp(along, 0.0, primitive.Strength) * primitive.Direction;
    case PrimitiveKind::Force:
      break;
  }
  return primitive.Strength * primitive.Direction;
}

enum class HoldState : std::uint8_t
{
  Holds,
  Yields,
  IsLeft
};

/**
 * Returns the state of a primitive that exerts a force.
 * @param isOld whether the force comes from another tick. A force near the full strength then
 * counts as full
 */
inline HoldState StateOf(const Primitive& p, const Vector3& force, bool isOld) noexcept
{
  // A force that was limited to the strength counts as full, in spite of rounding.
  const double full = (isOld ? 0.99 : 1.0 - 1e-12) * p.Strength;
  const double square = Dot(force, force);
  return square >= full * full                        ? HoldState::Yields
    : p.Kind == PrimitiveKind::Plane && square == 0.0 ? HoldState::IsLeft
                                                      : HoldState::Holds;
}

/** Returns the rounding error (N) of a condition. */
inline double RoundingOf(const HeldPrimitives& held) noexcept
{
  double largest = 0.0;
  for (int at = 0; at < held.Count; ++at)
  {
    largest = std::max(largest, Dot(held.Spring[at], held.Spring[at]));
  }
  return 4e-12 + 4e-15 * std::sqrt(largest);
}

} // namespace VolumeHaptics

#endif
