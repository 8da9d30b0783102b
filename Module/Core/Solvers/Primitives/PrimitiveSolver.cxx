// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveSolver.h"

#include "Core/Solvers/Primitives/PrimitiveHolds.h"
#include "Core/Solvers/Primitives/PrimitiveMultipliers.h"
#include "Core/Solvers/Primitives/PrimitiveNewton.h"
#include "Core/Solvers/Primitives/PrimitiveRay.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * A sweep has converged if no force changes by more than this limit (N), or by more than this
 * fraction of the largest force.
 */
constexpr double SettledChange = 1e-11;
constexpr double SettledFraction = 4e-16;
/** Largest stiffness of a spring (N/m). */
constexpr double StiffestSpring = 1e9;
///@{
/**
 * An exact balance is tried after each of the first sweeps, up to this number, and then at this
 * interval.
 */
constexpr int FirstLooks = 2;
constexpr int SweepsOfALook = 4;
///@}
/**
 * Multipliers are tried after this number of sweeps. Usually fewer suffice if directions do not
 * depend on each other.
 */
constexpr int SweepsAlone = 16;

/**
 * Returns whether no coordinate of a tip exceeds PrimitiveSet::FarthestAnchor. Returns false for
 * NaN.
 */
bool IsNear(const Vector3& tip) noexcept
{
  constexpr double most = PrimitiveSet::FarthestAnchor;
  return std::abs(tip.X) <= most && std::abs(tip.Y) <= most && std::abs(tip.Z) <= most;
}

bool Holds(const Primitive& primitive) noexcept
{
  return primitive.Kind != PrimitiveKind::Force && primitive.Strength > 0.0;
}

/** Returns whether the composition is exact for two directions. */
bool AreSeparate(const Primitive& a, const Primitive& b) noexcept
{
  constexpr double most = PrimitiveSolver::DirectionTolerance;
  const bool areLines = a.Kind == PrimitiveKind::Line && b.Kind == PrimitiveKind::Line;
  if (!areLines && std::abs(Dot(a.Direction, b.Direction)) <= most)
  {
    return true;
  }
  const Vector3 sine = Cross(a.Direction, b.Direction);
  return Dot(sine, sine) <= most * most;
}

/**
 * Returns whether the composition is exact for all holding primitives, each together with all
 * previous ones.
 */
bool IsComposable(const PrimitiveSet& set) noexcept
{
  const Primitive* first = nullptr;
  for (const Primitive& a : set)
  {
    if (!Holds(a))
    {
      continue;
    }
    first = first ? first : &a;
    if (!IsIdentical(a.Anchor, first->Anchor))
    {
      return false;
    }
    for (const Primitive* b = first; b != &a && a.Kind != PrimitiveKind::Point; ++b)
    {
      if (Holds(*b) && b->Kind != PrimitiveKind::Point && !AreSeparate(a, *b))
      {
        return false;
      }
    }
  }
  return true;
}

/** Sets the forces of the pushes, and 0 for all other primitives. Returns the sum of the pushes. */
Vector3 Push(const PrimitiveSet& set, PrimitiveForces& forces) noexcept
{
  Vector3 sum;
  for (int i = 0; i < PrimitiveSet::Most; ++i)
  {
    if (i >= set.GetSize() || !Holds(set[i]))
    {
      const bool pushes = i < set.GetSize() && set[i].Strength > 0.0;
      forces[i] = pushes ? set[i].Strength * set[i].Direction : Vector3{};
      sum += forces[i];
    }
  }
  return sum;
}

/** The dual problem: minimise |sum l_i|^2 / 2 + sum l_i.b_i, l_i in C_i. */
class Dual
{
public:
  Dual(const PrimitiveSet& set, double k, const Vector3& tip, const Vector3& towards,
    PrimitiveForces& forces) noexcept
    : Set(set)
    , Towards(towards)
    , Forces(forces)
  {
    const Vector3 push = Push(set, forces);
    double square = 0.0;
    for (int i = 0; i < set.GetSize(); ++i)
    {
      if (Holds(set[i]))
      {
        const int at = this->Count++;
        this->Number[at] = i;
        this->Spring[at] = k * (tip - set[i].Anchor) + push;
        square = std::max(square, Dot(this->Spring[at], this->Spring[at]));
        // The forces may come from another set, or from a file.
        forces[i] = IsFinite(forces[i]) ? Nearest(set[i], forces[i]) : Vector3{};
      }
    }
    this->Largest = std::sqrt(square);
    this->SumUp();
  }

  /** Tries PrimitiveRay.h and PrimitiveNewton.h. Returns whether one of them succeeded. */
  bool SolveExactly(bool isOld) noexcept
  {
    const HeldPrimitives held{ this->Set, this->Number, this->Spring, this->Count };
    return SolveBalanceOnRay(held, this->Towards, isOld, this->Forces, this->Sum) ||
      SolveExactBalance(held, isOld, this->Forces, this->Sum);
  }

  /** Uses PrimitiveMultipliers.h. Returns the number of evaluations. */
  int SolveByMultipliers(int mostLooks, bool& isFound) noexcept
  {
    const HeldPrimitives held{ this->Set, this->Number, this->Spring, this->Count };
    const int looks = SolveBalanceByMultipliers(held, mostLooks, this->Forces, isFound);
    isFound = this->SolveExactly(false) || isFound;
    return looks;
  }

protected:
  double Energy() const noexcept
  {
    double energy = 0.5 * Dot(this->Sum, this->Sum);
    for (int at = 0; at < this->Count; ++at)
    {
      energy += Dot(this->Forces[this->Number[at]], this->Spring[at]);
    }
    return energy;
  }

  void SumUp() noexcept
  {
    this->Sum = {};
    for (int at = 0; at < this->Count; ++at)
    {
      this->Sum += this->Forces[this->Number[at]];
    }
  }

  const PrimitiveSet& Set;
  const Vector3& Towards;
  PrimitiveForces& Forces;
  Vector3 Spring[PrimitiveSet::Most];  ///< b_i, the sum of the spring's force and the pushes
  int Number[PrimitiveSet::Most] = {}; ///< number of each primitive in the set
  int Count = 0;
  Vector3 Sum;
  double Largest = 0.0;
};

/** Sweeps over the dual problem. Stores the last sweeps for the acceleration. */
class Sweeper : public Dual
{
public:
  explicit Sweeper(const Dual& dual) noexcept
    : Dual(dual)
  {
  }

  /** Runs a sweep and stores the changes of the forces. Returns the largest change. */
  double Sweep() noexcept
  {
    double square = 0.0;
    this->SumUp();
    for (int at = 0; at < this->Count; ++at)
    {
      Vector3& force = this->Forces[this->Number[at]];
      const Vector3 others = this->Sum - force;
      const Vector3 next = Nearest(this->Set[this->Number[at]], -(this->Spring[at] + others));
      this->Change[at] = next - force;
      square = std::max(square, Dot(this->Change[at], this->Change[at]));
      this->Sum = others + next;
      force = next;
    }
    return std::sqrt(square);
  }

  /**
   * Computes from the last sweeps the forces that a sweep would not change if it were linear. Uses
   * them if their energy is not higher (Anderson's acceleration).
   */
  void Accelerate() noexcept
  {
    const int newest = this->Sweeps % Kept;
    Record& now = this->Past[newest];
    for (int at = 0; at < this->Count; ++at)
    {
      now.Change[at] = this->Change[at];
      now.Force[at] = this->Forces[this->Number[at]];
    }
    if (++this->Sweeps < Kept)
    {
      return;
    }
    // Find the mixture with the smallest changes: the newest record plus its differences from the
    // other ones.
    const Record* other[Kept - 1];
    for (int i = 0; i < Kept - 1; ++i)
    {
      other[i] = &this->Past[(newest + 1 + i) % Kept];
    }
    Matrix3 squares = { { {}, {}, {} } };
    Vector3 products;
    for (int at = 0; at < this->Count; ++at)
    {
      const Vector3& change = now.Change[at];
      const Vector3 a = change - other[0]->Change[at];
      const Vector3 b = change - other[1]->Change[at];
      const Vector3 c = change - other[2]->Change[at];
      squares.Row[0] += { Dot(a, a), Dot(a, b), Dot(a, c) };
      squares.Row[1] += { Dot(b, a), Dot(b, b), Dot(b, c) };
      squares.Row[2] += { Dot(c, a), Dot(c, b), Dot(c, c) };
      products += { Dot(a, change), Dot(b, change), Dot(c, change) };
    }
    const double scale = 1.0 / (squares.Row[0].X + squares.Row[1].Y + squares.Row[2].Z);
    squares = scale * squares;
    squares.Row[0].X += Regular;
    squares.Row[1].Y += Regular;
    squares.Row[2].Z += Regular;
    const Vector3 fraction = Inverse(squares) * (scale * products);
    if (!IsFinite(fraction))
    {
      return;
    }
    const double energy = this->Energy();
    for (int at = 0; at < this->Count; ++at)
    {
      const Vector3 mixed = now.Force[at] - fraction.X * (now.Force[at] - other[0]->Force[at]) -
        fraction.Y * (now.Force[at] - other[1]->Force[at]) -
        fraction.Z * (now.Force[at] - other[2]->Force[at]);
      this->Forces[this->Number[at]] = Nearest(this->Set[this->Number[at]], mixed);
    }
    this->SumUp();
    if (!(this->Energy() <= energy + EnergyRounding * this->Largest * this->Largest))
    {
      for (int at = 0; at < this->Count; ++at)
      {
        this->Forces[this->Number[at]] = now.Force[at];
      }
      this->SumUp();
    }
  }

  bool IsSettled(double change) const noexcept
  {
    return change <= SettledChange + SettledFraction * this->Largest;
  }

private:
  static constexpr int Kept = 4;
  static constexpr double Regular = 1e-14;
  static constexpr double EnergyRounding = 1e-15;

  struct Record
  {
    Vector3 Change[PrimitiveSet::Most];
    Vector3 Force[PrimitiveSet::Most];
  };

  Vector3 Change[PrimitiveSet::Most];
  Record Past[Kept];
  int Sweeps = 0;
};

Vector3 SumOf(const PrimitiveForces& forces) noexcept
{
  Vector3 sum;
  for (const Vector3& force : forces)
  {
    sum += force;
  }
  return sum;
}

/** Sweeps until an exact balance is found or the sweeps are used up. */
void DescendBySweeps(const Dual& dual, int mostSweeps, PrimitiveBalance& balance) noexcept
{
  Sweeper sweeper(dual);
  balance.IsUnfinished = true;
  while (balance.IsUnfinished && balance.Sweeps < mostSweeps)
  {
    balance.IsUnfinished = !sweeper.IsSettled(sweeper.Sweep());
    ++balance.Sweeps;
    const bool looks = balance.Sweeps <= FirstLooks || balance.Sweeps % SweepsOfALook == 0;
    if (balance.IsUnfinished && looks)
    {
      balance.IsUnfinished = !sweeper.SolveExactly(false);
    }
    if (balance.IsUnfinished && balance.Sweeps == SweepsAlone)
    {
      bool isFound = false;
      balance.Sweeps += sweeper.SolveByMultipliers(mostSweeps - balance.Sweeps, isFound);
      balance.IsUnfinished = !isFound;
    }
    else if (balance.IsUnfinished)
    {
      sweeper.Accelerate();
    }
  }
}

} // namespace

bool PrimitiveSolver::Compose(const PrimitiveSet& set, double k, const Vector3& tip,
  PrimitiveForces& forces, PrimitiveBalance& balance) noexcept
{
  if (!IsComposable(set))
  {
    return false;
  }
  const Vector3 push = Push(set, forces);
  const auto first = std::find_if(set.begin(), set.end(), Holds);
  balance = {};
  if (first == set.end())
  {
    balance.Proxy = tip + (1.0 / k) * push;
    balance.Force = push;
    return true;
  }
  // The part of the spring's force that no primitive holds yet.
  Vector3 rest = k * (tip - first->Anchor) + push;
  for (const PrimitiveKind kind :
    { PrimitiveKind::Plane, PrimitiveKind::Line, PrimitiveKind::Point })
  {
    for (int i = 0; i < set.GetSize(); ++i)
    {
      if (set[i].Kind == kind && Holds(set[i]))
      {
        forces[i] = Nearest(set[i], -rest);
        rest += forces[i];
      }
    }
  }
  balance.Proxy = first->Anchor + (1.0 / k) * rest;
  balance.Force = SumOf(forces);
  return true;
}

void PrimitiveSolver::Descend(const PrimitiveSet& set, double k, const Vector3& tip,
  PrimitiveForces& forces, PrimitiveBalance& balance, int mostSweeps,
  const Vector3& towards) noexcept
{
  balance = {};
  Dual dual(set, k, tip, towards, forces);
  // The forces of the last tick usually show which primitives hold and which yield.
  if (!dual.SolveExactly(true))
  {
    DescendBySweeps(dual, mostSweeps, balance);
  }
  balance.Force = SumOf(forces);
  balance.Proxy = tip + (1.0 / k) * balance.Force;
}

PrimitiveBalance Minimise(const PrimitiveSet& set, double k, const Vector3& tip,
  PrimitiveForces& forces, int mostSweeps, const Vector3& towards) noexcept
{
  PrimitiveBalance balance;
  if (!(k > 0.0 && k <= StiffestSpring) || !IsNear(tip))
  {
    forces = {};
    balance.Proxy = tip;
    return balance;
  }
  if (!PrimitiveSolver::Compose(set, k, tip, forces, balance))
  {
    PrimitiveSolver::Descend(set, k, tip, forces, balance, mostSweeps, towards);
  }
  return balance;
}

} // namespace VolumeHaptics
