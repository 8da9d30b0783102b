// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveSolver.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** N. A sweep that changes no force by more has arrived; and the share of the largest force. */
constexpr double SettledChange = 1e-12;
constexpr double SettledShare = 4e-16;
/** The sweeps between two attempts to go on along their change. */
constexpr int SweepsPerJump = 3;
/** N/m. */
constexpr double StiffestSpring = 1e9;

/** False for NaN, too. */
bool IsNear(const Vector3& tip) noexcept
{
  constexpr double most = PrimitiveSet::FarthestAnchor;
  return std::abs(tip.X) <= most && std::abs(tip.Y) <= most && std::abs(tip.Z) <= most;
}

bool Holds(const Primitive& primitive) noexcept
{
  return primitive.Kind != PrimitiveKind::Force && primitive.Strength > 0.0;
}

Vector3 AtMost(const Vector3& force, double most) noexcept
{
  const double square = Dot(force, force);
  return square > most * most ? (most / std::sqrt(square)) * force : force;
}

/** The point of C_i, the forces that a primitive can have, that is nearest to a force. */
Vector3 Nearest(const Primitive& primitive, const Vector3& force) noexcept
{
  const double along = Dot(force, primitive.Direction);
  switch (primitive.Kind)
  {
    case PrimitiveKind::Point:
      return AtMost(force, primitive.Strength);
    case PrimitiveKind::Line:
      return AtMost(force - along * primitive.Direction, primitive.Strength);
    case PrimitiveKind::Plane:
      return std::clamp(along, 0.0, primitive.Strength) * primitive.Direction;
    case PrimitiveKind::Force:
      break;
  }
  return primitive.Strength * primitive.Direction;
}

/** Whether the composition is exact for two directions. */
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

/** Whether the composition is exact for each primitive that holds, with the ones before it. */
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

/** Writes the pushes, and 0 for what does not hold; their sum. */
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
  Dual(const PrimitiveSet& set, double k, const Vector3& tip, PrimitiveForces& forces) noexcept
    : Set(set)
    , Forces(forces)
  {
    const Vector3 push = Push(set, forces);
    for (int i = 0; i < set.GetSize(); ++i)
    {
      if (Holds(set[i]))
      {
        const int at = this->Count++;
        this->Number[at] = i;
        this->Spring[at] = k * (tip - set[i].Anchor) + push;
        this->Largest = std::max(this->Largest, Norm(this->Spring[at]));
        // Of another set, maybe, or from a file.
        forces[i] = IsFinite(forces[i]) ? Nearest(set[i], forces[i]) : Vector3{};
      }
    }
    this->SumUp();
  }

  /** The largest change of a force. Writes the changes. */
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

  /** Goes on along the changes of the last sweep, if that lowers the energy. */
  void Jump() noexcept
  {
    Vector3 change;
    double slope = 0.0;
    for (int at = 0; at < this->Count; ++at)
    {
      change += this->Change[at];
      slope += Dot(this->Spring[at] + this->Sum, this->Change[at]);
    }
    const double length = -slope / Dot(change, change);
    // Also false for NaN.
    if (!(length > 0.0 && length < LongestJump))
    {
      return;
    }
    const PrimitiveForces before = this->Forces;
    const double energy = this->Energy();
    for (int at = 0; at < this->Count; ++at)
    {
      Vector3& force = this->Forces[this->Number[at]];
      force = Nearest(this->Set[this->Number[at]], force + length * this->Change[at]);
    }
    this->SumUp();
    if (!(this->Energy() < energy))
    {
      this->Forces = before;
      this->SumUp();
    }
  }

  bool IsSettled(double change) const noexcept
  {
    return change <= SettledChange + SettledShare * this->Largest;
  }

private:
  static constexpr double LongestJump = 1e12;

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
  PrimitiveForces& Forces;
  Vector3 Spring[PrimitiveSet::Most]; ///< b_i: of the spring and the pushes
  Vector3 Change[PrimitiveSet::Most];
  int Number[PrimitiveSet::Most] = {}; ///< in the set
  int Count = 0;
  Vector3 Sum;
  double Largest = 0.0;
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
  // What is left of the spring's force.
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
  PrimitiveForces& forces, PrimitiveBalance& balance) noexcept
{
  balance = {};
  balance.IsUnfinished = true;
  Dual dual(set, k, tip, forces);
  while (balance.IsUnfinished && balance.Sweeps < MostSweeps)
  {
    balance.IsUnfinished = !dual.IsSettled(dual.Sweep());
    ++balance.Sweeps;
    if (balance.IsUnfinished && balance.Sweeps % SweepsPerJump == 0)
    {
      dual.Jump();
    }
  }
  balance.Force = SumOf(forces);
  balance.Proxy = tip + (1.0 / k) * balance.Force;
}

PrimitiveBalance Minimise(
  const PrimitiveSet& set, double k, const Vector3& tip, PrimitiveForces& forces) noexcept
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
    PrimitiveSolver::Descend(set, k, tip, forces, balance);
  }
  return balance;
}

} // namespace VolumeHaptics
