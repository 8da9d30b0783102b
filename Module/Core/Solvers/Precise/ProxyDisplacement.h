// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the displacement of a proxy during one step of the tip, by the law of one material
 * point.
 *
 * The functions are inlined, like the law, because every tick needs them. A step of usual length is
 * computed as a whole, and a longer step in several parts.
 */
#ifndef ProxyDisplacement_h
#define ProxyDisplacement_h

#include "Core/Law/MaterialLaw.h"
#include "Core/Math/KernelInline.h"
#include "Core/State/PreciseState.h"

#include <algorithm>

namespace VolumeHaptics
{

namespace ProxyDisplacement
{
/**
 * Lengths of the parts of a tip's step, as fractions of the lag: CirclePart for parts with a mean
 * direction, FreePart for other parts. MostParts limits their number.
 */
constexpr double CirclePart = 0.1;
constexpr double FreePart = 0.005;
constexpr double MostParts = 64.0;
/** A spring's direction is known from this fraction of the circle's radius on. */
constexpr double OnCircle = 0.9;
/**
 * Longest spring (in radii) for which a mean direction is used. During a step of q radii, a small
 * angle between spring and step changes by the factor 1/2 + 1/(2 + 2 q) - q/2. For q above 3.2,
 * this would enlarge an angle caused by rounding.
 */
constexpr double LongestMean = 2.0;

/**
 * The part of a spring that the surface does not carry, and the circle within which friction and
 * drag hold this part.
 */
struct UnheldSpring
{
  Vector3 Lag;   ///< lag (m)
  double Length; ///< length of Lag
  double Radius; ///< radius (m) of the circle in which friction and drag hold the tip
  bool IsCircle; ///< whether they hold equally in all directions
};

VOLUME_HAPTICS_INLINE UnheldSpring ComputeUnheldSpring(
  const PrecisePoint& here, double compliance, const Vector3& lag, const SplitLag& split) noexcept
{
  const double most = split.Push > 0.0 ? here.SurfaceStrength * compliance : 0.0;
  const bool isThrough = std::abs(split.Push) > most;
  const double grip = here.Friction * (isThrough ? most : split.Push);
  UnheldSpring spring{ split.Tangent, split.Length, grip + here.Viscosity * compliance, true };
  if (isThrough)
  {
    spring.Lag = lag - most * here.Normal;
    spring.Length = Norm(spring.Lag);
    spring.IsCircle = grip == 0.0;
  }
  return spring;
}

/**
 * Returns the displacement by one part of a step: in the mean direction if there is one, otherwise
 * by `plain()`.
 */
template <typename Plain>
VOLUME_HAPTICS_INLINE Vector3 ComputePart(const PrecisePoint& here, double compliance,
  double longest, const Vector3& lagBefore, const SplitLag& splitBefore, const Vector3& lag,
  const SplitLag& split, const Plain& plain) noexcept
{
  const UnheldSpring now = ComputeUnheldSpring(here, compliance, lag, split);
  if (!now.IsCircle || !(now.Length > now.Radius) || now.Length > longest * now.Radius)
  {
    return plain();
  }
  const UnheldSpring before = ComputeUnheldSpring(here, compliance, lagBefore, splitBefore);
  if (!(before.Length > OnCircle * before.Radius))
  {
    return plain(); // the direction is not known yet
  }
  const Vector3 sum = (1.0 / before.Length) * before.Lag + (1.0 / now.Length) * now.Lag;
  const double square = Dot(sum, sum);
  if (square < 1.0)
  {
    return plain(); // the directions differ by more than a right angle, so their mean is useless
  }
  const Vector3 direction = (1.0 / std::sqrt(square)) * sum;
  const double along = Dot(now.Lag, direction);
  const Vector3 aside = now.Lag - along * direction;
  const double half = now.Radius * now.Radius - Dot(aside, aside);
  return half > 0.0 ? (along - std::sqrt(half)) * direction : plain();
}

/** Returns the displacement by a step that is divided into parts. */
Vector3 ComputeInParts(const PrecisePoint& here, double k, double longest, const Vector3& lagBefore,
  const Vector3& lag, double parts) noexcept;

/**
 * Returns the displacement (m) of a proxy while the tip's step changes the lag (m) from `lagBefore`
 * to `lag`. k (N/m) is the spring's stiffness, and `split` the split of `lag`.
 *
 * The result is of second order in the step if friction and drag hold equally in all directions.
 * `plain()` returns the displacement according to the law at the last lag alone. It is used for
 * steps without a mean direction, and for parts whose spring is longer than `longest` radii of the
 * circle.
 */
template <typename Plain>
VOLUME_HAPTICS_INLINE Vector3 Compute(const PrecisePoint& here, double k, double longest,
  const Vector3& lagBefore, const Vector3& lag, const SplitLag& split, const Plain& plain) noexcept
{
  const SplitLag before = Law::Split(lagBefore, here.Normal);
  const bool isThrough = std::max(split.Push, before.Push) * k > here.SurfaceStrength;
  // If the tip touches, leaves or breaks through a surface with friction in this step, no circle
  // bounds the spring, so use short parts.
  const bool isCircle =
    here.Friction == 0.0 || (!isThrough && (split.Push > 0.0) == (before.Push > 0.0));
  const double fraction = isCircle ? CirclePart : FreePart;
  const Vector3 step = lag - lagBefore;
  const double ratio = std::sqrt(Dot(step, step) / Dot(lag, lag)) / fraction;
  return ratio <= 1.0
    ? ComputePart(here, 1.0 / k, longest, lagBefore, before, lag, split, plain)
    : ComputeInParts(here, k, longest, lagBefore, lag, std::min(std::ceil(ratio), MostParts));
}
} // namespace ProxyDisplacement

} // namespace VolumeHaptics

#endif
