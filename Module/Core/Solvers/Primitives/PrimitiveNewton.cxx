// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveNewton.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

enum class HoldState : std::uint8_t
{
  Holds,
  Yields,
  IsLeft
};

constexpr int MostNewtonSteps = 6;
constexpr int MostConditions = 3;
/** Of a strength, so that forces that were cut to it count as such. */
constexpr double YieldShare = 1.0 - 1e-12;
/** N, and a share of the largest force: what rounding may leave of a condition. */
constexpr double NewtonSettled = 4e-12;
constexpr double NewtonShare = 4e-15;
/** A determinant of unit vectors that is less is that of directions in a plane. */
constexpr double LeastDeterminant = 1e-9;

Vector3 AcrossOf(const Vector3& v, const Vector3& q) noexcept
{
  return v - Dot(v, q) * q;
}

void AddOuter(double share, const Vector3& a, Matrix3& to) noexcept
{
  to.Row[0] += (share * a.X) * a;
  to.Row[1] += (share * a.Y) * a;
  to.Row[2] += (share * a.Z) * a;
}

class ExactBalance
{
public:
  ExactBalance(const HeldPrimitives& held, const PrimitiveForces& forces) noexcept
    : Held(held)
  {
    double largest = 0.0;
    for (int at = 0; at < held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      const Vector3& force = forces[static_cast<std::size_t>(held.Number[at])];
      const double square = Dot(force, force);
      const bool isFull = square >= YieldShare * YieldShare * p.Strength * p.Strength;
      this->State[at] = isFull                            ? HoldState::Yields
        : p.Kind == PrimitiveKind::Plane && square == 0.0 ? HoldState::IsLeft
                                                          : HoldState::Holds;
      this->Sum += force;
      largest = std::max(largest, Dot(held.Spring[at], held.Spring[at]));
    }
    this->Settled = NewtonSettled + NewtonShare * std::sqrt(largest);
  }

  bool Solve() noexcept
  {
    const bool areFew = this->CollectConditions();
    return (areFew && this->Step()) || this->Share();
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

  void AddCondition(const Vector3& direction, const Vector3& spring) noexcept
  {
    if (this->Conditions < MostConditions)
    {
      this->Row[this->Conditions] = direction;
      this->Wanted[this->Conditions] = -Dot(direction, spring);
    }
    ++this->Conditions;
  }

  /** False if there are too many. */
  bool CollectConditions() noexcept
  {
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      const Vector3& b = this->Held.Spring[at];
      this->First[at] = this->Conditions;
      if (this->State[at] != HoldState::Holds)
      {
        continue;
      }
      const Vector3& q = p.Direction;
      if (p.Kind == PrimitiveKind::Plane)
      {
        this->AddCondition(q, b);
      }
      else if (p.Kind == PrimitiveKind::Point)
      {
        this->AddCondition({ 1.0, 0.0, 0.0 }, b);
        this->AddCondition({ 0.0, 1.0, 0.0 }, b);
        this->AddCondition({ 0.0, 0.0, 1.0 }, b);
      }
      else
      {
        const bool isX = std::abs(q.X) < 0.6;
        const Vector3 aside = Cross(q, isX ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 });
        const Vector3 first = (1.0 / Norm(aside)) * aside;
        this->AddCondition(first, b);
        this->AddCondition(Cross(q, first), b);
      }
    }
    return this->Conditions <= MostConditions;
  }

  /** The forces of those that do not hold, and their slope; false if a direction is not there. */
  bool FindYielding(Matrix3& slope) noexcept
  {
    slope = Matrix3{};
    this->Yielding = {};
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] == HoldState::Holds)
      {
        continue;
      }
      if (this->State[at] == HoldState::IsLeft)
      {
        this->Force[at] = {};
        continue;
      }
      if (p.Kind == PrimitiveKind::Plane)
      {
        this->Force[at] = p.Strength * p.Direction;
      }
      else
      {
        const bool isLine = p.Kind == PrimitiveKind::Line;
        const Vector3 r = this->Held.Spring[at] + this->Sum;
        const Vector3 t = isLine ? AcrossOf(r, p.Direction) : r;
        const double length = Norm(t);
        if (!(length > this->Settled))
        {
          return false;
        }
        const Vector3 unit = (1.0 / length) * t;
        const double bend = p.Strength / length;
        this->Force[at] = -p.Strength * unit;
        AddOuter(bend, { 1.0, 0.0, 0.0 }, slope);
        AddOuter(bend, { 0.0, 1.0, 0.0 }, slope);
        AddOuter(bend, { 0.0, 0.0, 1.0 }, slope);
        AddOuter(-bend, unit, slope);
        if (isLine)
        {
          AddOuter(-bend, p.Direction, slope);
        }
      }
      this->Yielding += this->Force[at];
    }
    return true;
  }

  /** Newton's steps; false if what was assumed is not so. */
  bool Step() noexcept
  {
    for (int step = 0; step < MostNewtonSteps; ++step)
    {
      Matrix3 slope;
      if (!this->FindYielding(slope))
      {
        return false;
      }
      const Matrix3 inverse = Inverse(slope);
      const Vector3 free = inverse * (this->Yielding - this->Sum);
      // Of the conditions: the multipliers after which the step meets them.
      Vector3 back[MostConditions];
      Matrix3 products;
      Vector3 missing;
      double* const to[3] = { &missing.X, &missing.Y, &missing.Z };
      for (int i = 0; i < this->Conditions; ++i)
      {
        back[i] = inverse * this->Row[i];
      }
      const auto product = [&](int i, int j)
      {
        const int most = std::max(i, j);
        return most < this->Conditions ? Dot(this->Row[i], back[j]) : (i == j ? 1.0 : 0.0);
      };
      for (int i = 0; i < MostConditions; ++i)
      {
        products.Row[i] = { product(i, 0), product(i, 1), product(i, 2) };
        *to[i] = i < this->Conditions ? this->Wanted[i] - Dot(this->Row[i], this->Sum + free) : 0.0;
      }
      const Vector3 diagonal{ products.Row[0].X, products.Row[1].Y, products.Row[2].Z };
      if (!(Determinant(products) > LeastDeterminant * diagonal.X * diagonal.Y * diagonal.Z))
      {
        return false;
      }
      this->Multiplier = Inverse(products) * missing;
      const double* const m[3] = { &this->Multiplier.X, &this->Multiplier.Y, &this->Multiplier.Z };
      Vector3 change = free;
      for (int i = 0; i < this->Conditions; ++i)
      {
        change += *m[i] * back[i];
      }
      this->Sum += change;
      // Without lines and points that yield, one step is exact; its check costs no step.
      if (Dot(change, change) <= this->Settled * this->Settled || !this->IsCurved())
      {
        return this->Check();
      }
    }
    return false;
  }

  bool IsCurved() const noexcept
  {
    for (int at = 0; at < this->Held.Count; ++at)
    {
      if (this->State[at] == HoldState::Yields && this->At(at).Kind != PrimitiveKind::Plane)
      {
        return true;
      }
    }
    return false;
  }

  /** The forces at the place, and whether they are those of a balance. */
  bool Check() noexcept
  {
    const double* const m[3] = { &this->Multiplier.X, &this->Multiplier.Y, &this->Multiplier.Z };
    Matrix3 unused;
    if (!this->FindYielding(unused))
    {
      return false;
    }
    Vector3 all = this->Yielding;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] == HoldState::Holds)
      {
        const int rows = p.Kind == PrimitiveKind::Plane ? 1 : p.Kind == PrimitiveKind::Line ? 2 : 3;
        Vector3 force;
        for (int i = this->First[at]; i < this->First[at] + rows; ++i)
        {
          force += *m[i] * this->Row[i];
        }
        this->Force[at] = force;
        all += force;
      }
      if (!this->IsPossible(at))
      {
        return false;
      }
    }
    const Vector3 gap = all - this->Sum;
    this->Sum = all;
    return Dot(gap, gap) <= this->Settled * this->Settled;
  }

  bool IsPossible(int at) const noexcept
  {
    const Primitive& p = this->At(at);
    if (this->State[at] == HoldState::Holds)
    {
      const bool isPush =
        p.Kind != PrimitiveKind::Plane || Dot(this->Force[at], p.Direction) >= 0.0;
      return isPush && Dot(this->Force[at], this->Force[at]) <= p.Strength * p.Strength;
    }
    if (p.Kind == PrimitiveKind::Plane)
    {
      const double depth = Dot(this->Held.Spring[at] + this->Sum, p.Direction);
      return this->State[at] == HoldState::IsLeft ? depth >= -this->Settled
                                                  : depth <= this->Settled;
    }
    return true;
  }

  /** All that hold, at their common anchor. */
  bool Share() noexcept
  {
    const Vector3* anchor = nullptr;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      if (this->State[at] == HoldState::Holds)
      {
        anchor = anchor ? anchor : &this->Held.Spring[at];
        if (!IsIdentical(*anchor, this->Held.Spring[at]))
        {
          return false;
        }
      }
    }
    if (!anchor)
    {
      return false;
    }
    this->Sum = -*anchor;
    Matrix3 unused;
    if (!this->FindYielding(unused))
    {
      return false;
    }
    Matrix3 all{ { {}, {}, {} } };
    double strengths = 0.0;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] != HoldState::Holds)
      {
        continue;
      }
      strengths += p.Strength;
      if (p.Kind == PrimitiveKind::Plane)
      {
        AddOuter(p.Strength, p.Direction, all);
        continue;
      }
      AddOuter(p.Strength, { 1.0, 0.0, 0.0 }, all);
      AddOuter(p.Strength, { 0.0, 1.0, 0.0 }, all);
      AddOuter(p.Strength, { 0.0, 0.0, 1.0 }, all);
      if (p.Kind == PrimitiveKind::Line)
      {
        AddOuter(-p.Strength, p.Direction, all);
      }
    }
    if (!(Determinant(all) > LeastDeterminant * strengths * strengths * strengths))
    {
      return false;
    }
    const Vector3 share = Inverse(all) * (this->Sum - this->Yielding);
    Vector3 sum = this->Yielding;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] == HoldState::Holds)
      {
        const Vector3& q = p.Direction;
        this->Force[at] = p.Strength *
          (p.Kind == PrimitiveKind::Plane     ? Dot(share, q) * q
              : p.Kind == PrimitiveKind::Line ? AcrossOf(share, q)
                                              : share);
        sum += this->Force[at];
      }
      if (!this->IsPossible(at))
      {
        return false;
      }
    }
    const Vector3 gap = sum - this->Sum;
    this->Sum = sum;
    return Dot(gap, gap) <= this->Settled * this->Settled;
  }

  const HeldPrimitives& Held;
  HoldState State[PrimitiveSet::Most] = {};
  Vector3 Force[PrimitiveSet::Most];
  int First[PrimitiveSet::Most] = {}; ///< condition
  Vector3 Row[MostConditions];
  double Wanted[MostConditions] = {};
  int Conditions = 0;
  Vector3 Multiplier;
  Vector3 Sum;
  Vector3 Yielding; ///< the sum of the forces of those that do not hold
  double Settled = 0.0;
};

} // namespace

bool FindExactBalance(const HeldPrimitives& held, PrimitiveForces& forces, Vector3& sum) noexcept
{
  ExactBalance balance(held, forces);
  if (!balance.Solve())
  {
    return false;
  }
  balance.Write(forces, sum);
  return true;
}

} // namespace VolumeHaptics
