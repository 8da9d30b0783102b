// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The displacement of a proxy while the tip makes one step, by the law of one material point.
 *
 * Inlined, like the law: a step of usual length has one part, which every tick needs.
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
 * Lengths of the parts of a tip's step, as fractions of the lag: for parts with a mean direction,
 * and for parts without.
 */
constexpr double CirclePart = 0.1;
constexpr double FreePart = 0.005;
constexpr double MostParts = 64.0;
/** The fraction of a circle's radius beyond which a spring has a direction. */
constexpr double OnCircle = 0.9;
/**
 * The longest spring, in radii, that has a mean direction: beside a step of q radii, a small angle
 * between spring and step changes by the factor 1/2 + 1/(2 + 2 q) - q/2, which for q above 3.2
 * makes an angle of rounding grow.
 */
constexpr double LongestMean = 2.0;

/**
 * The part of a spring that the surface does not hold, and the circle within which friction and
 * drag hold it.
 */
struct UnheldSpring
{
  Vector3 Lag;   ///< m
  double Length; ///< the length of Lag
  double Radius; ///< m, the radius of the circle in which friction and drag hold the tip
  bool IsCircle; ///< false if they hold more in some directions
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
 * Returns the displacement by one part of a step: in the mean direction if there is one, else
 * `plain()`.
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
    return plain(); // no direction yet
  }
  const Vector3 sum = (1.0 / before.Length) * before.Lag + (1.0 / now.Length) * now.Lag;
  const double square = Dot(sum, sum);
  if (square < 1.0)
  {
    return plain(); // the mean of two directions that are more than a right angle apart is useless
  }
  const Vector3 direction = (1.0 / std::sqrt(square)) * sum;
  const double along = Dot(now.Lag, direction);
  const Vector3 aside = now.Lag - along * direction;
  const double half = now.Radius * now.Radius - Dot(aside, aside);
  return half > 0.0 ? (along - std::sqrt(half)) * direction : plain();
}

/** Returns the displacement by a step in more than one part. */
Vector3 ComputeInParts(const PrecisePoint& here, double k, double longest, const Vector3& lagBefore,
  const Vector3& lag, double parts) noexcept;

/**
 * Returns the displacement of a proxy (m) while the tip's step takes the spring of stiffness k
 * (N/m) from one lag (m) to another, whose split is given, too.
 *
 * The result is of second order in the step if friction and drag hold all directions alike.
 * `plain()` returns the displacement by the law at the last lag alone, for steps without a mean
 * direction, and for parts whose spring is longer than `longest` radii of the circle.
 */
template <typename Plain>
VOLUME_HAPTICS_INLINE Vector3 Compute(const PrecisePoint& here, double k, double longest,
  const Vector3& lagBefore, const Vector3& lag, const SplitLag& split, const Plain& plain) noexcept
{
  const SplitLag before = Law::Split(lagBefore, here.Normal);
  const bool isThrough = std::max(split.Push, before.Push) * k > here.SurfaceStrength;
  // No circle if the tip leaves or meets the surface.
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
