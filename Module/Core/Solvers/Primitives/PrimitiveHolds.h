// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a primitive does in a balance, as forces that are nearly those of the balance tell.
 */
#ifndef PrimitiveHolds_h
#define PrimitiveHolds_h

#include "Core/Solvers/Primitives/PrimitiveNewton.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

enum class HoldState : std::uint8_t
{
  Holds,
  Yields,
  IsLeft
};

/** @param isOld the force is that of another tick: almost a whole strength counts as one */
inline HoldState StateOf(const Primitive& p, const Vector3& force, bool isOld) noexcept
{
  // Forces that were cut to the strength count as full.
  const double full = (isOld ? 0.99 : 1.0 - 1e-12) * p.Strength;
  const double square = Dot(force, force);
  return square >= full * full                        ? HoldState::Yields
    : p.Kind == PrimitiveKind::Plane && square == 0.0 ? HoldState::IsLeft
                                                      : HoldState::Holds;
}

/** What rounding may leave of a condition (N). */
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
