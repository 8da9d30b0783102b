// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/Primitive.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Returns the strength to use, which is 0 if the primitive's strength is not valid. */
double UsableStrength(const Primitive& primitive) noexcept
{
  const double s = primitive.Strength;
  if (!(s > 0.0) || (primitive.Kind == PrimitiveKind::Force && std::isinf(s)))
  {
    return 0.0; // NaN is not valid, nor is an infinite push
  }
  return std::fmin(s, PrimitiveSet::MostStrength);
}

/** Scales a direction to unit length. Returns false if its length is 0, too large or not finite. */
bool Normalise(Vector3& direction) noexcept
{
  constexpr double safe = 1e100;
  const double square = Dot(direction, direction);
  if (square < safe && square > 1.0 / safe)
  {
    direction = (1.0 / std::sqrt(square)) * direction;
    return true;
  }
  const double largest =
    std::fmax(std::abs(direction.X), std::fmax(std::abs(direction.Y), std::abs(direction.Z)));
  if (!IsFinite(direction) || !(largest > 0.0))
  {
    return false;
  }
  // Scale by the largest component first. Otherwise the squares would overflow or vanish, and the
  // reciprocal of a tiny number might be infinite.
  direction = { direction.X / largest, direction.Y / largest, direction.Z / largest };
  direction = (1.0 / Norm(direction)) * direction;
  return true;
}

bool IsNearEnough(const Vector3& anchor) noexcept
{
  constexpr double most = PrimitiveSet::FarthestAnchor;
  // The comparisons are false for NaN, too.
  return std::abs(anchor.X) <= most && std::abs(anchor.Y) <= most && std::abs(anchor.Z) <= most;
}

} // namespace

bool PrimitiveSet::Add(const Primitive& primitive) noexcept
{
  if (this->Size >= Most)
  {
    return false;
  }
  Primitive& added = this->Items[this->Size++];
  added = primitive;
  added.Strength = UsableStrength(primitive);
  const bool hasDirection =
    primitive.Kind == PrimitiveKind::Point || added.Strength == 0.0 || Normalise(added.Direction);
  const bool hasAnchor = primitive.Kind == PrimitiveKind::Force || IsNearEnough(primitive.Anchor);
  if (!hasDirection || !hasAnchor)
  {
    added.Strength = 0.0;
  }
  return true;
}

double PrimitiveSet::SumStrengths() const noexcept
{
  double sum = 0.0;
  for (const Primitive& primitive : *this)
  {
    sum += primitive.Strength;
  }
  return sum;
}

} // namespace VolumeHaptics
