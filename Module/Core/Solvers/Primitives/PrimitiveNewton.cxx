// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveNewton.h"

#include "Core/Solvers/Primitives/PrimitiveHolds.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int MostBalanceSteps = 6;
constexpr int MostConditions = 3;
constexpr int MostRounds = 6;
/** Three unit vectors count as coplanar if their determinant is below this limit. */
constexpr double LeastDeterminant = 1e-9;

Vector3 AcrossOf(const Vector3& v, const Vector3& q) noexcept
{
  return v - Dot(v, q) * q;
}

void AddDiagonal(double fraction, Matrix3& to) noexcept
{
  to.Row[0].X += fraction;
  to.Row[1].Y += fraction;
  to.Row[2].Z += fraction;
}

void AddOuter(double fraction, const Vector3& a, Matrix3& to) noexcept
{
  to.Row[0] += (fraction * a.X) * a;
  to.Row[1] += (fraction * a.Y) * a;
  to.Row[2] += (fraction * a.Z) * a;
}

class ExactBalance
{
public:
  ExactBalance(const HeldPrimitives& held, const PrimitiveForces& forces, bool isOld) noexcept
    : Held(held)
    , Settled(RoundingOf(held))
  {
    for (int at = 0; at < held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      const Vector3& force = forces[static_cast<std::size_t>(held.Number[at])];
      this->State[at] = StateOf(p, force, isOld);
      const bool isFull = this->State[at] == HoldState::Yields;
      this->Force[at] = isFull ? (p.Strength / Norm(force)) * force : force;
      this->Sum += this->Force[at];
    }
  }

  /**
   * Computes the balance. If the result contradicts the assumed states, corrects them and repeats
   * the computation, a few times.
   */
  bool Solve() noexcept
  {
    const Vector3 start = this->Sum;
    for (int round = 0; round < MostRounds; ++round)
    {
      this->Sum = start;
      this->Contradictions = 0;
      this->Conditions = 0;
      this->IsOff = false;
      // If there are more than MostConditions conditions, there is a balance only if all springs
      // have the same anchor. Fraction() computes the force there.
      if (this->CollectConditions() ? this->Step() : this->Fraction())
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

  void AddCondition(const Vector3& direction, const Vector3& spring) noexcept
  {
    if (this->Conditions < MostConditions)
    {
      this->Row[this->Conditions] = direction;
      this->Wanted[this->Conditions] = -Dot(direction, spring);
    }
    ++this->Conditions;
  }

  /** Collects the conditions. Returns false if there are too many. */
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
        const Vector3 first = UnitAcross(q);
        this->AddCondition(first, b);
        this->AddCondition(Cross(q, first), b);
      }
    }
    return this->Conditions <= MostConditions;
  }

  /**
   * Computes the forces of primitives that do not hold, without their turn, and the slope of these
   * forces with w. The force of a yielding line or point turns with its place. Direction and place
   * are both unknowns, so that steps are good even if the primitive yields only a little, where its
   * force turns fast.
   */
  void ComputeYielding(Matrix3& slope) noexcept
  {
    slope = Matrix3{};
    this->Yielding = {};
    this->IsCurved = false;
    this->Curvature = 0.0;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      if (this->State[at] == HoldState::Holds)
      {
        continue;
      }
      const Primitive& p = this->At(at);
      if (p.Kind == PrimitiveKind::Plane)
      {
        const bool isLeft = this->State[at] == HoldState::IsLeft;
        this->Force[at] = isLeft ? Vector3{} : p.Strength * p.Direction;
        this->Yielding += this->Force[at];
        continue;
      }
      this->IsCurved = true;
      const Vector3 r = this->Held.Spring[at] + this->Sum;
      const Vector3 unit = (1.0 / p.Strength) * this->Force[at];
      const double curvature = 1.0 / std::max(-Dot(unit, r), this->Settled);
      const double bend = p.Strength * curvature;
      this->Curvature = std::max(this->Curvature, curvature);
      this->Unit[at] = unit;
      this->Bend[at] = bend;
      AddDiagonal(bend, slope);
      AddOuter(-bend, unit, slope);
      if (p.Kind == PrimitiveKind::Line)
      {
        AddOuter(-bend, p.Direction, slope);
      }
      this->Yielding += this->Force[at] - bend * AsideOf(p, unit, r);
    }
  }

  /**
   * Returns the component of `v` perpendicular to the force's direction `unit` and, for a line,
   * also perpendicular to the line. A yielding force has a constant magnitude, so it can change
   * only in this direction.
   */
  static Vector3 AsideOf(const Primitive& p, const Vector3& unit, const Vector3& v) noexcept
  {
    const Vector3 aside = AcrossOf(v, unit);
    return p.Kind == PrimitiveKind::Line ? AcrossOf(aside, p.Direction) : aside;
  }

  /**
   * Turns the forces of yielding lines and points according to a change of the sum.
   */
  void Turn(const Vector3& change) noexcept
  {
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] == HoldState::Yields && p.Kind != PrimitiveKind::Plane)
      {
        const Vector3 r = this->Held.Spring[at] + this->Sum + change;
        const Vector3 turned = this->Force[at] - this->Bend[at] * AsideOf(p, this->Unit[at], r);
        this->Force[at] = (p.Strength / Norm(turned)) * turned;
      }
    }
  }

  /** Runs Newton's method. Returns false if the assumed states are wrong. */
  bool Step() noexcept
  {
    for (int step = 0; step < MostBalanceSteps; ++step)
    {
      Matrix3 slope;
      this->ComputeYielding(slope);
      const Matrix3 inverse = this->IsCurved ? Inverse(slope) : slope;
      Vector3 change = inverse * (this->Yielding - this->Sum);
      if (this->Conditions > 0 && !this->MeetConditions(inverse, change))
      {
        return false;
      }
      this->Turn(change);
      this->Sum += change;
      // Without yielding lines and points, one step is exact. With them, the next step would be
      // about the square of this one, if both are measured as fractions of the distance of the
      // nearest anchor.
      const double square = Dot(change, change);
      if (!this->IsCurved || square * this->Curvature <= this->Settled)
      {
        return this->Check();
      }
    }
    return false;
  }

  /**
   * Changes a step by multipliers, so that it fulfils the conditions. Returns false if the
   * conditions are linearly dependent.
   */
  bool MeetConditions(const Matrix3& inverse, Vector3& step) noexcept
  {
    const int n = this->Conditions;
    Vector3 back[MostConditions];
    Matrix3 products;
    double missing[MostConditions] = {};
    for (int i = 0; i < n; ++i)
    {
      back[i] = inverse * this->Row[i];
      missing[i] = this->Wanted[i] - Dot(this->Row[i], this->Sum + step);
    }
    const auto product = [&](int i, int j) { return Dot(this->Row[i], back[j]); };
    products.Row[0].X = product(0, 0);
    if (n > 1)
    {
      products.Row[0].Y = products.Row[1].X = product(0, 1);
      products.Row[1].Y = product(1, 1);
    }
    if (n > 2)
    {
      products.Row[0].Z = products.Row[2].X = product(0, 2);
      products.Row[1].Z = products.Row[2].Y = product(1, 2);
      products.Row[2].Z = product(2, 2);
    }
    const double size = products.Row[0].X * products.Row[1].Y * products.Row[2].Z;
    if (!(Determinant(products) > LeastDeterminant * size))
    {
      return false;
    }
    this->Multiplier = Inverse(products) * Vector3{ missing[0], missing[1], missing[2] };
    const double* const m[3] = { &this->Multiplier.X, &this->Multiplier.Y, &this->Multiplier.Z };
    for (int i = 0; i < n; ++i)
    {
      step += *m[i] * back[i];
    }
    return true;
  }

  /** Computes the forces at the present place. Returns whether they are in balance. */
  bool Check() noexcept
  {
    const double* const m[3] = { &this->Multiplier.X, &this->Multiplier.Y, &this->Multiplier.Z };
    Vector3 all;
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
      }
      all += this->Force[at];
      this->Correct(at);
    }
    const Vector3 gap = all - this->Sum;
    this->Sum = all;
    return this->Contradictions == 0 && !this->IsOff &&
      Dot(gap, gap) <= this->Settled * this->Settled;
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
      if (state == HoldState::Yields)
      {
        this->Force[at] = (p.Strength / Norm(this->Force[at])) * this->Force[at];
      }
    }
    else if (p.Kind == PrimitiveKind::Plane)
    {
      const double depth = Dot(this->Held.Spring[at] + this->Sum, p.Direction);
      const bool isLeft = state == HoldState::IsLeft;
      state =
        (isLeft ? depth >= -this->Settled : depth <= this->Settled) ? state : HoldState::Holds;
    }
    else
    {
      const Vector3 r = this->Held.Spring[at] + this->Sum;
      const Vector3 aside = AsideOf(p, (1.0 / p.Strength) * this->Force[at], r);
      const bool isBack = -Dot(this->Force[at], r) < -this->Settled * p.Strength;
      state = isBack ? HoldState::Holds : HoldState::Yields;
      this->IsOff = this->IsOff || Dot(aside, aside) > this->Settled * this->Settled;
    }
    this->Contradictions += state != before ? 1 : 0;
  }

  /**
   * Computes the forces of all holding primitives at their common anchor. Returns false if they are
   * too weak.
   */
  bool Fraction() noexcept
  {
    const Vector3* const anchor = this->Held.Spring;
    this->Yielding = {};
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (!IsIdentical(*anchor, this->Held.Spring[at]))
      {
        return false;
      }
      // At the anchor, a line or point holds with any force. A plane, however, may be left, or push
      // with its full strength.
      if (p.Kind != PrimitiveKind::Plane)
      {
        this->State[at] = HoldState::Holds;
      }
      const bool isFull = this->State[at] == HoldState::Yields;
      this->Force[at] = isFull ? p.Strength * p.Direction : Vector3{};
      this->Yielding += this->Force[at];
    }
    this->Sum = -*anchor;
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
      AddDiagonal(p.Strength, all);
      if (p.Kind == PrimitiveKind::Line)
      {
        AddOuter(-p.Strength, p.Direction, all);
      }
    }
    if (!(Determinant(all) > LeastDeterminant * strengths * strengths * strengths))
    {
      return false;
    }
    const Vector3 fraction = Inverse(all) * (this->Sum - this->Yielding);
    Vector3 sum = this->Yielding;
    for (int at = 0; at < this->Held.Count; ++at)
    {
      const Primitive& p = this->At(at);
      if (this->State[at] == HoldState::Holds)
      {
        const Vector3& q = p.Direction;
        this->Force[at] = p.Strength *
          (p.Kind == PrimitiveKind::Plane     ? Dot(fraction, q) * q
              : p.Kind == PrimitiveKind::Line ? AcrossOf(fraction, q)
                                              : fraction);
        sum += this->Force[at];
      }
      this->Correct(at);
    }
    const Vector3 gap = sum - this->Sum;
    this->Sum = sum;
    return this->Contradictions == 0 && !this->IsOff &&
      Dot(gap, gap) <= this->Settled * this->Settled;
  }

  const HeldPrimitives& Held;
  HoldState State[PrimitiveSet::Most] = {};
  Vector3 Force[PrimitiveSet::Most];
  int First[PrimitiveSet::Most] = {}; ///< number of each primitive's first condition
  Vector3 Row[MostConditions];
  double Wanted[MostConditions] = {};
  int Conditions = 0;
  int Contradictions = 0;
  bool IsOff = false; ///< whether the force of a yielding primitive does not point along its place
  ///@{
  /**
   * State of yielding lines and points: whether there are any, the direction of each force, and how
   * fast each direction turns.
   */
  bool IsCurved = false;
  double Curvature = 0.0; ///< largest change of direction per newton
  Vector3 Unit[PrimitiveSet::Most];
  double Bend[PrimitiveSet::Most] = {};
  ///@}
  Vector3 Multiplier;
  Vector3 Sum;
  Vector3 Yielding; ///< sum of the forces of the primitives that do not hold
  double Settled = 0.0;
};

} // namespace

bool SolveExactBalance(
  const HeldPrimitives& held, bool isOld, PrimitiveForces& forces, Vector3& sum) noexcept
{
  ExactBalance balance(held, forces, isOld);
  if (!balance.Solve())
  {
    return false;
  }
  balance.Write(forces, sum);
  return true;
}

} // namespace VolumeHaptics
