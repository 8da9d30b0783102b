// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseMotion.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Parts of a tip's step, as shares of the spring, where the mean direction is known and where not.
 */
constexpr double CirclePart = 0.1;
constexpr double FreePart = 0.005;
constexpr double MostParts = 64.0;
/** Of a circle's radius: whoever is nearer to its edge has a direction. */
constexpr double OnCircle = 0.9;

/**
 * The part of a spring (m) that the surface does not hold, and in how wide a circle friction and
 * drag do.
 */
struct Rest
{
  Vector3 Way;
  double Length;
  double Radius;
  bool IsCircle; ///< or else directions are held differently
};

Rest FindRest(const Spot& here, double compliance, const Vector3& lag) noexcept
{
  const double push = Dot(lag, here.Normal);
  const double most = push > 0.0 ? here.SurfaceStrength * compliance : 0.0;
  const bool isThrough = std::abs(push) > most;
  const double held = isThrough ? most : push;
  const double grip = here.Friction * held;
  Rest rest;
  rest.Way = lag - held * here.Normal;
  rest.Length = Norm(rest.Way);
  rest.Radius = grip + here.Viscosity * compliance;
  rest.IsCircle = grip == 0.0 || !isThrough;
  return rest;
}

/**
 * The way of a proxy while its spring goes from one lag to another, by the law of one place: in the
 * mean direction, where there is one; or else `plain`.
 */
Vector3 MovePart(const Spot& here, double compliance, const Vector3& lagBefore, const Vector3& lag,
  const Vector3& plain) noexcept
{
  const Rest rest = FindRest(here, compliance, lag);
  if (!rest.IsCircle || !(rest.Length > rest.Radius))
  {
    return plain;
  }
  const Rest before = FindRest(here, compliance, lagBefore);
  if (!(before.Length > OnCircle * before.Radius))
  {
    return plain; // it had no direction yet
  }
  const Vector3 sum = (1.0 / before.Length) * before.Way + (1.0 / rest.Length) * rest.Way;
  const double square = Dot(sum, sum);
  if (square < 1.0)
  {
    return plain; // more than a right angle has no mean worth taking
  }
  const Vector3 direction = (1.0 / std::sqrt(square)) * sum;
  const double along = Dot(rest.Way, direction);
  const Vector3 aside = rest.Way - along * direction;
  const double half = rest.Radius * rest.Radius - Dot(aside, aside);
  return half > 0.0 ? (along - std::sqrt(half)) * direction : plain;
}

} // namespace

Vector3 MoveAlong(const Spot& here, double k, const Vector3& lagBefore, const Vector3& lag,
  const Vector3& plain) noexcept
{
  const double compliance = 1.0 / k;
  const Vector3 step = lag - lagBefore;
  const double push = Dot(lag, here.Normal);
  const double pushBefore = Dot(lagBefore, here.Normal);
  const bool isThrough = std::max(push, pushBefore) * k > here.SurfaceStrength;
  // Nor where a surface is left or met.
  const bool isCircle = here.Friction == 0.0 || (!isThrough && (push > 0.0) == (pushBefore > 0.0));
  const double share = isCircle ? CirclePart : FreePart;
  const double parts =
    std::clamp(std::ceil(std::sqrt(Dot(step, step) / Dot(lag, lag)) / share), 1.0, MostParts);
  if (parts == 1.0)
  {
    return MovePart(here, compliance, lagBefore, lag, plain);
  }
  Vector3 way;
  for (double part = 1.0; part <= parts; part += 1.0)
  {
    const Vector3 from = lagBefore + ((part - 1.0) / parts) * step - way;
    const Vector3 to = lagBefore + (part / parts) * step - way;
    const SplitLag split = Law::Split(to, here.Normal);
    way += MovePart(
      here, compliance, from, to, Law::Move(here, k, split, Law::Weigh(here, k, split), Vector3{}));
  }
  return way;
}

} // namespace VolumeHaptics
