// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveRay.h"

#include "Core/Solvers/Primitives/PrimitiveHolds.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int MostRayTurns = 8;
constexpr int MostRayRounds = 5;
/**
 * If the sine of the angle between a line and the ray is below this limit, the line's force turns
 * too fast for Newton's method.
 */
constexpr double LeastRaySine = 1e-6;
constexpr double MostRayAngle = 0.5;

class RayBalance
{
public:
  RayBalance(const HeldPrimitives& held, const Vector3& towards, bool isOld,
    const PrimitiveForces& forces) noexcept
    : Held(held)
    , Spring(*held.Spring)
    , Settled(RoundingOf(held))
  {
    Vector3 rest = this->Spring;
    for (int at = 0; at < held.Count; ++at)
    {
      const Vector3& force = forces[static_cast<std::size_t>(held.Number[at])];
      this->State[at] = StateOf(this->At(at), force, isOld);
      rest += force;
    }
    const bool isUnknown = towards.X == 0.0 && towards.Y == 0.0 && towards.Z == 0.0;
    this->Ray = isUnknown ? rest : towards;
  }

  /**
   * Computes the balance. If the result contradicts the assumed states, corrects them and repeats
   * the computation, a few times.
   */
  bool Solve() noexcept
  {
    if (!this->SetRay(this->Ray))
    {
      return false;
    }
    for (int round = 0; round < MostRayRounds; ++round)
    {
      this->Contradictions = 0;
      if (!this->KeepConditions() || !this->Turn())
      {
        return false;
      }
      if (this->Check())
      {
        return true;
      }
      if (this->Contradictions == 0)
      {
        return false;
      }
    }
    return false;
  }

  void Write(PrimitiveForces& forces, Vector3& sum) const noexcept
  {
    for (int at = 0; at < this->Held.Count; ++at)
    {
      forces[static_cast<std::size_t>(this->Held.Number[at])] = this->Force[at];
    }
    sum = this->Sum;
  }

private:
  const Primitive& At(int at) const noexcept { return this->Held.Set[this->Held.Number[at]]; }

  /** Sets the ray along a vector. Returns false if the vector has no direction. */
  bool SetRay(const Vector3& to) noexcept
  {
    const double length = Norm(to);
    this->Ray = (1.0 / length) * to;
    return length > this->Settled && std::isfinite(length);
  }

  /**
   * Restricts the ray to the conditions of the holding primitives. Returns false if no ray is left.
   */
  bool KeepConditions() noexcept
  {
    this->Slides = 0;
    this->Along = -1;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      if (this->State[at] != HoldState::Holds)
      {
        continue;
      }
      const PrimitiveKind kind = this->At(at).Kind;
      const bool isPlane = kind == PrimitiveKind::Plane && this->Slides < 2 && this->Along < 0;
      const bool isLine = kind == PrimitiveKind::Line && this->Slides == 0 && this->Along < 0;
      if (isPlane)
      {
        this->Slide[this->Slides++] = at;
      }
      else if (isLine)
      {
        this->Along = at;
      }
      else
      {
        return false;
      }
    }
    if (this->Along >= 0)
    {
      return this->SetLine(this->At(this->Along).Direction);
    }
    if (this->Slides == 2)
    {
      return this->SetLine(
        Cross(this->At(this->Slide[0]).Direction, this->At(this->Slide[1]).Direction));
    }
    if (this->Slides == 1)
    {
      const Vector3& q = this->At(this->Slide[0]).Direction;
      const Vector3 inPlane = this->Ray - Dot(this->Ray, q) * q;
      return Norm(inPlane) > LeastRaySine && this->SetRay(inPlane);
    }
    return true;
  }

  /** Sets the ray to one of the two directions of a line. Returns false if this is not possible. */
  bool SetLine(const Vector3& line) noexcept
  {
    return Norm(line) > LeastRaySine &&
      this->SetRay(std::copysign(1.0, Dot(line, this->Ray)) * line);
  }

  /**
   * Computes the directions, perpendicular to the ray, in which it can turn. Returns their number.
   */
  int ComputeTurns(Vector3 turns[2]) const noexcept
  {
    if (this->Along >= 0 || this->Slides == 2)
    {
      return 0;
    }
    if (this->Slides == 1)
    {
      turns[0] = Cross(this->At(this->Slide[0]).Direction, this->Ray);
      return 1;
    }
    // The two vectors are the images of two axes under the reflection that maps the third axis to
    // the ray.
    const Vector3& d = this->Ray;
    const double sign = std::copysign(1.0, d.Z);
    const double share = -1.0 / (sign + d.Z);
    turns[0] = { 1.0 + sign * share * d.X * d.X, sign * share * d.X * d.Y, -sign * d.X };
    turns[1] = { share * d.X * d.Y, sign + share * d.Y * d.Y, -d.Y };
    return 2;
  }

  /**
   * Turns the ray until b + F has no component across it. Returns false if this does not converge.
   */
  bool Turn() noexcept
  {
    for (int i = 0; i < MostRayTurns; ++i)
    {
      Vector3 turns[2];
      const int count = this->ComputeTurns(turns);
      Slope slope;
      if (!this->ComputeYielding(turns, slope))
      {
        return false;
      }
      const Vector3 rest = this->Spring + this->Fraction * this->Yielding;
      const double first = count > 0 ? Dot(rest, turns[0]) : 0.0;
      const double second = count > 1 ? Dot(rest, turns[1]) : 0.0;
      if (first * first + second * second <= 0.25 * this->Settled * this->Settled)
      {
        return true;
      }
      const double aa = this->Fraction * slope.AA + this->Distance;
      const double ab = this->Fraction * slope.AB;
      const double bb = count > 1 ? this->Fraction * slope.BB + this->Distance : 1.0;
      const double determinant = aa * bb - (count > 1 ? ab * ab : 0.0);
      const double inverse = 1.0 / determinant;
      double a = inverse * (bb * first - ab * second);
      double b = count > 1 ? inverse * (aa * second - ab * first) : 0.0;
      const double most = std::max(std::abs(a), std::abs(b));
      // The comparison is false for NaN, too.
      if (!(most < 1e9))
      {
        return false;
      }
      if (most > MostRayAngle)
      {
        a *= MostRayAngle / most;
        b *= MostRayAngle / most;
      }
      this->SetRay(this->Ray + a * turns[0] + b * turns[1]);
    }
    return false;
  }

  struct Slope
  {
    double AA = 0.0;
    double AB = 0.0;
    double BB = 0.0;
  };

  /**
   * Computes the forces of the primitives that yield on the ray, how they turn with the ray, and
   * the proxy's place on the ray. Returns false if there is no such place.
   */
  bool ComputeYielding(const Vector3 turns[2], Slope& slope) noexcept
  {
    this->Yielding = {};
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] != HoldState::Yields)
      {
        continue;
      }
      if (p.Kind == PrimitiveKind::Plane)
      {
        this->Force[at] = p.Strength * p.Direction;
        this->Yielding += this->Force[at];
        continue;
      }
      const bool isLine = p.Kind == PrimitiveKind::Line;
      const Vector3 aside =
        isLine ? this->Ray - Dot(this->Ray, p.Direction) * p.Direction : this->Ray;
      const double size = isLine ? Norm(aside) : 1.0;
      if (!(size > LeastRaySine))
      {
        return false;
      }
      const double inverse = 1.0 / size;
      const double bend = p.Strength * inverse;
      this->Force[at] = -bend * aside;
      this->Yielding += this->Force[at];
      // Only the component of a turn that is perpendicular to both line and force turns the force.
      const double share = inverse * inverse;
      const double firstAlong = isLine ? Dot(turns[0], p.Direction) : 0.0;
      const double secondAlong = isLine ? Dot(turns[1], p.Direction) : 0.0;
      const double firstAside = Dot(turns[0], aside);
      const double secondAside = Dot(turns[1], aside);
      slope.AA += bend * (1.0 - firstAlong * firstAlong - share * firstAside * firstAside);
      slope.AB -= bend * (firstAlong * secondAlong + share * firstAside * secondAside);
      slope.BB += bend * (1.0 - secondAlong * secondAlong - share * secondAside * secondAside);
    }
    const double ofSpring = Dot(this->Spring, this->Ray);
    const double ofForces = Dot(this->Yielding, this->Ray);
    const double distance = ofSpring + ofForces;
    this->Distance = std::max(distance, 0.0);
    this->Fraction = distance >= 0.0 ? 1.0 : -ofSpring / ofForces;
    // If the spring pulls along the ray, but less strongly than the primitives can hold, all of
    // them hold. The comparisons are false for NaN, too.
    return distance >= 0.0 || (ofSpring > 0.0 && ofForces < 0.0);
  }

  /**
   * Computes the forces of the holding primitives. Returns whether all forces belong to a balance.
   */
  bool Check() noexcept
  {
    const Vector3 rest = this->Spring + this->Fraction * this->Yielding;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      this->Force[at] =
        this->State[at] == HoldState::Yields ? this->Fraction * this->Force[at] : Vector3{};
    }
    if (this->Along >= 0)
    {
      this->Force[this->Along] = Dot(rest, this->Ray) * this->Ray - rest;
    }
    else if (this->Slides > 0)
    {
      const Vector3& q = this->At(this->Slide[0]).Direction;
      const double first = -Dot(rest, q);
      if (this->Slides == 1)
      {
        this->Force[this->Slide[0]] = first * q;
      }
      else
      {
        const Vector3& other = this->At(this->Slide[1]).Direction;
        const double second = -Dot(rest, other);
        const double cosine = Dot(q, other);
        const double share = 1.0 / (1.0 - cosine * cosine);
        this->Force[this->Slide[0]] = share * (first - cosine * second) * q;
        this->Force[this->Slide[1]] = share * (second - cosine * first) * other;
      }
    }
    this->Sum = {};
    for (int at = 0; at < this->Held.Count; ++at)
    {
      this->Sum += this->Force[at];
      this->Correct(at);
    }
    const Vector3 gap = this->Spring + this->Sum - this->Distance * this->Ray;
    return this->Contradictions == 0 && Dot(gap, gap) <= this->Settled * this->Settled;
  }

  /** Changes the assumed state of a primitive if its force or place contradicts it. */
  void Correct(int at) noexcept
  {
    const Primitive& p = this->At(at);
    HoldState& state = this->State[at];
    const HoldState before = state;
    if (state == HoldState::Holds)
    {
      const bool isPull = p.Kind == PrimitiveKind::Plane && Dot(this->Force[at], p.Direction) < 0.0;
      const bool isMore = Dot(this->Force[at], this->Force[at]) > p.Strength * p.Strength;
      state = isPull ? HoldState::IsLeft : (isMore ? HoldState::Yields : HoldState::Holds);
    }
    else if (p.Kind == PrimitiveKind::Plane)
    {
      const double depth = this->Distance * Dot(this->Ray, p.Direction);
      const bool isLeft = state == HoldState::IsLeft;
      state =
        (isLeft ? depth >= -this->Settled : depth <= this->Settled) ? state : HoldState::Holds;
    }
    this->Contradictions += state != before ? 1 : 0;
  }

  const HeldPrimitives& Held;
  const Vector3& Spring;
  HoldState State[PrimitiveSet::Most] = {};
  Vector3 Force[PrimitiveSet::Most];
  Vector3 Ray;
  double Distance = 0.0; ///< place of the proxy on the ray (N)
  /** Fraction of the yielding forces that is used. It is below 1 if all primitives hold. */
  double Fraction = 1.0;
  Vector3 Yielding; ///< sum of the yielding forces
  Vector3 Sum;
  int Slide[2] = {}; ///< numbers of the holding planes
  int Slides = 0;
  int Along = -1; ///< number of the holding line; -1 if there is none
  int Contradictions = 0;
  double Settled = 0.0;
};

bool HaveCommonAnchor(const HeldPrimitives& held) noexcept
{
  const Vector3* const first = held.Spring;
  return std::all_of(first, first + held.Count,
    [first](const Vector3& spring) { return IsIdentical(*first, spring); });
}

} // namespace

bool SolveBalanceOnRay(const HeldPrimitives& held, const Vector3& towards, bool isOld,
  PrimitiveForces& forces, Vector3& sum) noexcept
{
  if (held.Count == 0 || !HaveCommonAnchor(held))
  {
    return false;
  }
  RayBalance balance(held, towards, isOld, forces);
  if (!balance.Solve())
  {
    return false;
  }
  balance.Write(forces, sum);
  return true;
}

} // namespace VolumeHaptics
