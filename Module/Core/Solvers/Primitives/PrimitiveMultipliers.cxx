// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveMultipliers.h"

#include "Core/Solvers/Primitives/PrimitiveHolds.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * The penalty m. A larger penalty increases the rounding errors of holding primitives; a smaller
 * one needs more rounds.
 */
constexpr double Penalty = 1000.0;
/**
 * A round has converged if no force changes by more than this limit (N). The error of places is
 * then at most 1/m of it.
 */
constexpr double SettledRound = 1e-10;
constexpr int MostHalvings = 30;
/** Least decrease of the function, as a fraction of the decrease predicted by its slope. */
constexpr double LeastFall = 1e-4;

class MultiplierRound
{
public:
  MultiplierRound(const HeldPrimitives& held, int mostLooks, PrimitiveForces& forces) noexcept
    : Held(held)
    , MostLooks(mostLooks)
    , Forces(forces)
  {
    for (int at = 0; at < held.Count; ++at)
    {
      this->Sum += this->ForceOf(at);
    }
    this->Look(this->Sum);
  }

  int GetLooks() const noexcept { return this->Looks; }
  bool IsSpent() const noexcept { return this->Looks >= this->MostLooks; }

  /** Makes one step of Newton's method. Returns false if the method has converged. */
  bool Step(double settled) noexcept
  {
    const Vector3 slope = this->Slope;
    if (Dot(slope, slope) <= settled * settled)
    {
      return false;
    }
    const Vector3 step = -(Inverse(this->ComputeCurvature()) * slope);
    const double promised = Dot(slope, step);
    const double before = this->Value;
    const Vector3 from = this->Sum;
    // Stop if the function does not decrease along the step, or if its slope is NaN.
    if (!(promised < 0.0))
    {
      return false;
    }
    // The function is convex: its value is lower where it still decreases along the step. Check the
    // slope, because its rounding error is smaller than that of the value.
    double least = 0.0;
    double most = 1.0;
    double fraction = 1.0;
    for (int i = 0; i < MostHalvings && !this->IsSpent(); ++i)
    {
      this->Look(from + fraction * step);
      const double rise = Dot(this->Slope, step);
      const bool isPast = rise > 0.0 && this->Value > before + LeastFall * fraction * promised;
      const bool isShort = fraction < 1.0 && rise < 0.5 * promised;
      if (!isPast && !isShort)
      {
        return true;
      }
      (isPast ? most : least) = fraction;
      fraction = 0.5 * (least + most);
    }
    // If the slope has decreased, the result is as exact as rounding allows.
    if (Dot(this->Slope, this->Slope) < Dot(slope, slope))
    {
      return true;
    }
    this->Look(from);
    return false;
  }

  /** Takes over the forces at this place. Returns the largest change of a force. */
  double Apply() noexcept
  {
    double square = 0.0;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      Vector3& force = this->ForceOf(at);
      const Vector3 change = this->Next[at] - force;
      square = std::max(square, Dot(change, change));
      force = this->Next[at];
    }
    this->Look(this->Sum);
    return std::sqrt(square);
  }

private:
  const Primitive& At(int at) const noexcept { return this->Held.Set[this->Held.Number[at]]; }
  Vector3& ForceOf(int at) const noexcept
  {
    return this->Forces[static_cast<std::size_t>(this->Held.Number[at])];
  }

  /** Evaluates the function and its slope for a sum of the forces. */
  void Look(const Vector3& sum) noexcept
  {
    ++this->Looks;
    this->Sum = sum;
    this->Slope = sum;
    this->Value = 0.5 * Dot(sum, sum);
    for (int at = 0; at < this->Held.Count; ++at)
    {
      this->Wish[at] = this->ForceOf(at) - Penalty * (this->Held.Spring[at] + sum);
      this->Next[at] = Nearest(this->At(at), this->Wish[at]);
      const Vector3 beyond = this->Wish[at] - this->Next[at];
      this->Slope = this->Slope - this->Next[at];
      // Add |u|^2 - |u - P|^2, computed without a difference of large numbers.
      this->Value += Dot(this->Next[at], this->Next[at] + 2.0 * beyond) / (2.0 * Penalty);
    }
  }

  Matrix3 ComputeCurvature() const noexcept
  {
    Matrix3 all{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
    const auto add = [&all](double fraction, const Vector3& v)
    {
      all.Row[0] += (fraction * v.X) * v;
      all.Row[1] += (fraction * v.Y) * v;
      all.Row[2] += (fraction * v.Z) * v;
    };
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      const Vector3& q = p.Direction;
      const double along = Dot(this->Wish[at], q);
      if (p.Kind == PrimitiveKind::Plane)
      {
        add(along > 0.0 && along < p.Strength ? Penalty : 0.0, q);
        continue;
      }
      const bool isLine = p.Kind == PrimitiveKind::Line;
      const Vector3 turning = isLine ? this->Wish[at] - along * q : this->Wish[at];
      const double size = Norm(turning);
      const bool isFull = size > p.Strength;
      const double fraction = Penalty * (isFull ? p.Strength / size : 1.0);
      all.Row[0].X += fraction;
      all.Row[1].Y += fraction;
      all.Row[2].Z += fraction;
      if (isLine)
      {
        add(-fraction, q);
      }
      if (isFull)
      {
        add(-fraction / (size * size), turning);
      }
    }
    return all;
  }

  const HeldPrimitives& Held;
  const int MostLooks;
  int Looks = 0;
  PrimitiveForces& Forces;
  Vector3 Wish[PrimitiveSet::Most]; ///< u_i
  Vector3 Next[PrimitiveSet::Most]; ///< P_i(u_i)
  Vector3 Sum;                      ///< w
  Vector3 Slope;
  double Value = 0.0;
};

} // namespace

int SolveBalanceByMultipliers(
  const HeldPrimitives& held, int mostLooks, PrimitiveForces& forces, bool& isSettled) noexcept
{
  MultiplierRound round(held, mostLooks, forces);
  const double rounding = RoundingOf(held);
  isSettled = false;
  while (!round.IsSpent() && !isSettled)
  {
    while (!round.IsSpent() && round.Step(rounding))
    {
    }
    isSettled = round.Apply() <= SettledRound + 10.0 * rounding;
  }
  return round.GetLooks();
}

} // namespace VolumeHaptics
