// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PreciseMotion.h"

namespace VolumeHaptics
{
namespace
{

/** Parts of a tip's step, as shares of the spring, where the mean direction is known and where not. */
constexpr double CirclePart = 0.1;
constexpr double FreePart = 0.005;
constexpr double MostParts = 64.0;
/** Of a circle's radius: whoever is nearer to its edge has a direction. */
constexpr double OnCircle = 0.9;

/** The part of a spring (m) that the surface does not hold, and in how wide a circle friction and drag do. */
struct Rest
{
  Vector3 Way;
  double Length;
  double Radius;
  bool IsCircle; ///< or else directions are held differently
};

Rest FindRest(const Spot& here, double k, const SplitLag& split, const Balance& balance,
  const Vector3& lag) noexcept
{
  Rest rest;
  rest.Way = lag - (balance.Normal / k) * here.Normal;
  rest.Length = Norm(rest.Way);
  const double grip = here.Friction * balance.Normal;
  rest.Radius = (grip + here.Viscosity) / k;
  rest.IsCircle = grip == 0.0 || (split.Push > 0.0 && !balance.IsThrough);
  return rest;
}

/** The way of a proxy while its spring goes from one lag to another, by the law of one place. */
Vector3 MovePart(const Spot& here, double k, const Vector3& lagBefore, const Vector3& lag) noexcept
{
  const SplitLag split = Law::Split(lag, here.Normal);
  const Balance balance = Law::Weigh(here, k, split);
  const Vector3 way = Law::Move(here, k, split, balance, Vector3{});
  const Rest rest = FindRest(here, k, split, balance, lag);
  if (!rest.IsCircle || !(rest.Length > rest.Radius))
  {
    return way;
  }
  const SplitLag splitBefore = Law::Split(lagBefore, here.Normal);
  const Rest before = FindRest(here, k, splitBefore, Law::Weigh(here, k, splitBefore), lagBefore);
  if (!(before.Length > OnCircle * before.Radius))
  {
    return way; // it had no direction yet
  }
  const Vector3 sum = (1.0 / before.Length) * before.Way + (1.0 / rest.Length) * rest.Way;
  const double length = Norm(sum);
  if (length < 1.0)
  {
    return way; // more than a right angle has no mean worth taking
  }
  const Vector3 direction = (1.0 / length) * sum;
  const double along = Dot(rest.Way, direction);
  const Vector3 aside = rest.Way - along * direction;
  const double square = rest.Radius * rest.Radius - Dot(aside, aside);
  return square > 0.0 ? (along - std::sqrt(square)) * direction : way;
}

} // namespace

Vector3 MoveAlong(const Spot& here, double k, const Vector3& lagBefore, const Vector3& lag) noexcept
{
  const Vector3 step = lag - lagBefore;
  const double push = k * Dot(lag, here.Normal);
  const double pushBefore = k * Dot(lagBefore, here.Normal);
  const bool isThrough = std::max(push, pushBefore) > here.SurfaceStrength;
  // Nor where a surface is left or met.
  const bool isCircle = here.Friction == 0.0 || (!isThrough && (push > 0.0) == (pushBefore > 0.0));
  const double longest = (isCircle ? CirclePart : FreePart) * Norm(lag);
  const double parts = std::clamp(std::ceil(Norm(step) / longest), 1.0, MostParts);
  Vector3 way;
  for (double part = 1.0; part <= parts; part += 1.0)
  {
    const Vector3 from = lagBefore + ((part - 1.0) / parts) * step - way;
    const Vector3 to = lagBefore + (part / parts) * step - way;
    way += MovePart(here, k, from, to);
  }
  return way;
}

} // namespace VolumeHaptics
