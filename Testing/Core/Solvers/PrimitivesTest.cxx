// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Balances of haptic primitives, compared with closed forms and with another algorithm: the primal
 * problem by ADMM, with the prox of each potential by itself, in long double and without hurry.
 */

#include "Core/Solvers/Primitives/PrimitiveSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr double Stiffness = 500.0;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A set from a cold start.
PrimitiveBalance BalanceOf(const std::vector<Primitive>& primitives, const Vector3& tip)
{
  PrimitiveSet set;
  for (const Primitive& primitive : primitives)
  {
    EXPECT_TRUE(set.Add(primitive));
  }
  PrimitiveForces forces{};
  return Minimise(set, Stiffness, tip, forces);
}

using Long = long double;
struct Long3
{
  Long X[3];
};
Long3 operator+(const Long3& a, const Long3& b)
{
  return { { a.X[0] + b.X[0], a.X[1] + b.X[1], a.X[2] + b.X[2] } };
}
Long3 operator*(Long s, const Long3& a)
{
  return { { s * a.X[0], s * a.X[1], s * a.X[2] } };
}
Long3 operator-(const Long3& a, const Long3& b)
{
  return a + Long(-1) * b;
}
Long Inner(const Long3& a, const Long3& b)
{
  return a.X[0] * b.X[0] + a.X[1] * b.X[1] + a.X[2] * b.X[2];
}
Long3 ToLong(const Vector3& a)
{
  return { { a.X, a.Y, a.Z } };
}

/// argmin |x - y|^2 / 2 + phi(x), positions in newtons (times the stiffness): the closed forms.
Long3 SingleProx(const Primitive& p, const Long3& y)
{
  const Long3 q = ToLong(p.Direction);
  const Long s = p.Strength;
  const Long3 d = y - Long(Stiffness) * ToLong(p.Anchor);
  const Long h = Inner(d, q);
  const Long3 across = d - h * q;
  switch (p.Kind)
  {
    case PrimitiveKind::Force:
      return y + s * q;
    case PrimitiveKind::Point:
      return y - std::min(Long(1), s / std::sqrt(Inner(d, d))) * d;
    case PrimitiveKind::Line:
      return y - std::min(Long(1), s / std::sqrt(Inner(across, across))) * across;
    default:
      return h >= 0 ? y : (h >= -s ? y - h * q : y + s * q);
  }
}

/// The balance by ADMM; the worst residual of the last round in `residual`.
Vector3 SolveSlowly(const PrimitiveSet& set, const Vector3& tip, Long& residual)
{
  const Long3 y = Long(Stiffness) * ToLong(tip);
  const int n = set.GetSize();
  std::vector<Long3> x(n, y);
  std::vector<Long3> u(n, Long3{});
  Long3 z = y;
  residual = 1;
  for (int round = 0; round < 400000 && residual > 1e-13L; ++round)
  {
    Long3 sum = y;
    for (int i = 0; i < n; ++i)
    {
      x[i] = SingleProx(set[i], z - u[i]);
      sum = sum + x[i] + u[i];
    }
    const Long3 next = (Long(1) / Long(n + 1)) * sum;
    residual = std::sqrt(Inner(next - z, next - z));
    z = next;
    for (int i = 0; i < n; ++i)
    {
      const Long3 gap = x[i] - z;
      u[i] = u[i] + gap;
      residual = std::max(residual, std::sqrt(Inner(gap, gap)));
    }
  }
  const Long k = Stiffness;
  return { double(z.X[0] / k), double(z.X[1] / k), double(z.X[2] / k) };
}

class PrimitiveDice
{
public:
  explicit PrimitiveDice(unsigned seed)
    : Engine(seed)
  {
  }
  double operator()(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() >> 11) * 0x1p-53);
  }
  Vector3 Place(double size)
  {
    return { (*this)(-size, size), (*this)(-size, size), (*this)(-size, size) };
  }
  Vector3 Direction()
  {
    Vector3 v = this->Place(1.0);
    while (Norm(v) < 0.1 || Norm(v) > 1.0)
    {
      v = this->Place(1.0);
    }
    return (1.0 / Norm(v)) * v;
  }
  /// Any primitives with anchors of their own.
  PrimitiveSet AnySet(int size)
  {
    PrimitiveSet set;
    for (int i = 0; i < size; ++i)
    {
      const auto kind = static_cast<PrimitiveKind>(this->Engine() % 4);
      set.Add({ kind, this->Direction(), this->Place(0.004), (*this)(0.0, 2.0) });
    }
    return set;
  }
  /// Primitives of the composition: one anchor, directions of a frame.
  PrimitiveSet FrameSet(int size)
  {
    const Vector3 a = this->Direction();
    const Vector3 b = Cross(a, this->Direction());
    const Vector3 frame[3] = { a, b, Cross(a, b) };
    const Vector3 anchor = this->Place(0.004);
    PrimitiveSet set;
    for (int i = 0; i < size; ++i)
    {
      const auto kind = static_cast<PrimitiveKind>(this->Engine() % 4);
      const Vector3 axis = frame[kind == PrimitiveKind::Line ? 0 : this->Engine() % 3];
      const Vector3 q = kind == PrimitiveKind::Force ? this->Direction() : axis;
      set.Add({ kind, this->Engine() % 2 ? q : -q, anchor, (*this)(0.0, 2.0) });
    }
    return set;
  }
  /// Any primitives at one anchor, as the modes of a place have them; two in three are parallel to
  /// the first one or at a right angle to it.
  PrimitiveSet PlaceSet(int size)
  {
    const Vector3 anchor = this->Place(0.004);
    const Vector3 along = this->Direction();
    PrimitiveSet set;
    for (int i = 0; i < size; ++i)
    {
      const auto kind = static_cast<PrimitiveKind>((this->Engine() + i) % 4);
      const Vector3 q = this->Direction();
      const Vector3 choice[3] = { q, along, Cross(q, along) };
      set.Add({ kind, choice[this->Engine() % 3], anchor, (*this)(0.0, 2.0) });
    }
    return set;
  }

private:
  std::mt19937_64 Engine;
};
} // namespace

TEST(Primitives, ALineLeavesItsDirectionFreeAndYieldsAcrossIt)
{
  // P1: 2 N on 500 N/m are a spring of 4 mm.
  const Primitive line{ PrimitiveKind::Line, { 3.0, 0.0, 0.0 }, {}, 2.0 };
  const PrimitiveBalance along = BalanceOf({ line }, { 0.05, 0.0, 0.0 });
  EXPECT_EQ(Norm(along.Force), 0.0);
  EXPECT_NEAR(along.Proxy.X, 0.05, 1e-16);
  for (const double across : { 0.001, 0.0039, 0.0041, 0.05 })
  {
    const PrimitiveBalance balance = BalanceOf({ line }, { 0.02, -across, 0.0 });
    EXPECT_NEAR(balance.Force.Y, std::min(Stiffness * across, 2.0), 1e-14);
    EXPECT_EQ(balance.Force.X, 0.0);
    EXPECT_EQ(balance.Force.Z, 0.0);
    EXPECT_NEAR(balance.Proxy.Y, std::min(0.0, 0.004 - across), 1e-16);
  }
}

TEST(Primitives, ForcePointAndPlaneHaveTheirClosedForms)
{
  // P2.
  const PrimitiveBalance pushed =
    BalanceOf({ { PrimitiveKind::Force, { 0.0, 2.0, 0.0 }, {}, 2.0 } }, { 0.1, 0.2, 0.3 });
  EXPECT_EQ(pushed.Force.Y, 2.0);
  EXPECT_NEAR(pushed.Proxy.Y, 0.204, 1e-16);
  const Primitive point{ PrimitiveKind::Point, {}, { 0.0, 0.0, 0.01 }, 1.0 };
  EXPECT_NEAR(BalanceOf({ point }, { 0.0, 0.001, 0.01 }).Proxy.Y, 0.0, 1e-18);
  EXPECT_NEAR(BalanceOf({ point }, { 0.0, 0.003, 0.01 }).Proxy.Y, 0.001, 1e-16);
  EXPECT_NEAR(BalanceOf({ point }, { 0.0, 0.003, 0.01 }).Force.Y, -1.0, 1e-14);
  const Primitive plane{ PrimitiveKind::Plane, { 0.0, 0.0, 0.5 }, { 9.0, 7.0, 0.01 }, 1.0 };
  EXPECT_EQ(Norm(BalanceOf({ plane }, { 0.0, 0.0, 0.02 }).Force), 0.0);
  EXPECT_NEAR(BalanceOf({ plane }, { 0.0, 0.0, 0.009 }).Proxy.Z, 0.01, 1e-16);
  EXPECT_NEAR(BalanceOf({ plane }, { 0.0, 0.0, 0.009 }).Force.Z, 0.5, 1e-12);
  EXPECT_NEAR(BalanceOf({ plane }, { 0.0, 0.0, 0.0 }).Proxy.Z, 0.002, 1e-16);
  EXPECT_NEAR(BalanceOf({ plane }, { 0.0, 0.0, 0.0 }).Force.Z, 1.0, 1e-14);
}

TEST(Primitives, BalancesAreThoseOfASlowSolver)
{
  PrimitiveDice dice(3);
  double worst = 0.0;
  int composed = 0;
  for (int round = 0; round < 900; ++round)
  {
    const int size = 2 + round % 7;
    PrimitiveSet set = round % 3 == 0 ? dice.FrameSet(size) : dice.AnySet(size);
    if (round < 3) // P10: a line and an oblique plane of 1 N
    {
      set.Clear();
      set.Add({ PrimitiveKind::Line, { 1.0, 0.0, 0.0 }, {}, 1.0 });
      set.Add({ PrimitiveKind::Plane, { 1.0, 0.0, 1.0 }, {}, 1.0 });
    }
    const Vector3 tip = dice.Place(0.012);
    Long residual = 1;
    const Vector3 expected = SolveSlowly(set, tip, residual);
    ASSERT_LE(residual, 1e-13L) << "the slow solver needs more rounds";
    PrimitiveForces forces{};
    const PrimitiveBalance balance = Minimise(set, Stiffness, tip, forces);
    composed += balance.Sweeps == 0;
    ASSERT_FALSE(balance.IsUnfinished) << "set " << round << " of " << size;
    worst = std::max(worst, Stiffness * Norm(balance.Proxy - expected));
    EXPECT_NEAR(Norm(balance.Force - Stiffness * (balance.Proxy - tip)), 0.0, 1e-11);
    // From other forces, descent arrives at the same balance.
    PrimitiveForces other;
    other.fill({ 1.0, -2.0, NaN });
    other[0] = { 1.0, 0.3, -0.7 };
    PrimitiveBalance descended;
    int calls = 0;
    do
    {
      PrimitiveSolver::Descend(set, Stiffness, tip, other, descended);
    } while (descended.IsUnfinished && ++calls < 10);
    EXPECT_FALSE(descended.IsUnfinished) << "a resting tip is reached in a few ticks";
    worst = std::max(worst, Stiffness * Norm(descended.Proxy - expected));
  }
  EXPECT_LT(worst, 1e-9) << "N";
  EXPECT_GE(composed, 297);
}

TEST(Primitives, YieldingALittleIsFoundAsWell)
{
  // The tip is a hundredth of a millimetre farther than what the strengths hold, as in a tick.
  PrimitiveDice dice(8);
  double worst = 0.0;
  int unfinished = 0;
  int swept = 0;
  for (int round = 0; round < 120; ++round)
  {
    PrimitiveSet set;
    for (int i = 0; i < 2 + round % 4; ++i)
    {
      const auto kind = static_cast<PrimitiveKind>(1 + int(dice(0.0, 3.0)));
      set.Add({ kind, dice.Direction(), {}, dice(0.5, 2.0) });
    }
    PrimitiveForces forces{};
    const PrimitiveBalance most = Minimise(set, Stiffness, dice.Place(1.0), forces);
    const PrimitiveForces far = forces;
    const Vector3 tip = (-1.0 / Stiffness) * most.Force + dice.Place(1e-5);
    Long residual = 1;
    const Vector3 expected = SolveSlowly(set, tip, residual);
    forces = {};
    const PrimitiveBalance balance = Minimise(set, Stiffness, tip, forces);
    unfinished += balance.IsUnfinished;
    PrimitiveForces old;
    int sweeps = 0;
    // Wherever the proxy is expected to be; from the right place, mostly without a sweep.
    for (const Vector3& towards : { -expected, dice.Direction(), expected })
    {
      old = far;
      const PrimitiveBalance led = Minimise(set, Stiffness, tip, old, 256, towards);
      unfinished += led.IsUnfinished;
      sweeps = led.Sweeps;
      const bool isKnown = residual <= 1e-13L && !led.IsUnfinished;
      worst = std::max(worst, isKnown ? Stiffness * Norm(led.Proxy - expected) : 0.0);
      for (int i = 0; i < set.GetSize(); ++i)
      {
        EXPECT_LE(Norm(old[static_cast<std::size_t>(i)]), set[i].Strength * (1.0 + 1e-14));
      }
    }
    swept += sweeps > 0 && Stiffness * Norm(expected) > 1e-6;
    // A little less than what all of them hold together holds nothing back.
    old = far;
    const Vector3 nearer = (-(1.0 - 1e-4) / Stiffness) * most.Force;
    const PrimitiveBalance still = Minimise(set, Stiffness, nearer, old, 256, most.Proxy);
    EXPECT_LT(Stiffness * Norm(still.Proxy), 1e-9) << round;
    if (residual <= 1e-13L && !balance.IsUnfinished)
    {
      worst = std::max(worst, Stiffness * Norm(balance.Proxy - expected));
    }
    else
    {
      EXPECT_LT(Stiffness * Norm(balance.Proxy - expected), 1e-4);
    }
  }
  EXPECT_LT(worst, 1e-9) << "N";
  EXPECT_LE(unfinished, 2);
  EXPECT_LE(swept, 6);
}

TEST(Primitives, TheCompositionBearsDirectionsThatAreOffByRounding)
{
  PrimitiveDice dice(4);
  double worst = 0.0;
  for (int round = 0; round < 2000; ++round)
  {
    const PrimitiveSet set = dice.FrameSet(5);
    PrimitiveSet near;
    for (Primitive primitive : set)
    {
      primitive.Direction += (0.25 * PrimitiveSolver::DirectionTolerance) * dice.Direction();
      near.Add(primitive);
    }
    const Vector3 tip = dice.Place(0.012);
    PrimitiveForces forces{};
    PrimitiveBalance exact;
    PrimitiveBalance off;
    ASSERT_TRUE(PrimitiveSolver::Compose(set, Stiffness, tip, forces, exact));
    ASSERT_TRUE(PrimitiveSolver::Compose(near, Stiffness, tip, forces, off));
    worst = std::max(worst, Norm(exact.Force - off.Force));
  }
  EXPECT_LT(worst, 1e-13) << "N";
}

TEST(Primitives, AreNonExpansiveAndPullNoMoreThanTheirStrengths)
{
  // 1.4 million steps of a tip; of each kind of set as many as its solver takes in some seconds.
  PrimitiveDice dice(5);
  for (int round = 0; round < 70; ++round)
  {
    const bool isFrame = round < 50;
    const PrimitiveSet set = isFrame ? dice.FrameSet(1 + round % 8)
      : round < 60                   ? dice.AnySet(2 + round % 5)
                                     : dice.PlaceSet(2 + round % 5);
    const double most = set.SumStrengths();
    PrimitiveForces forces{};
    Vector3 tip = dice.Place(0.01);
    PrimitiveBalance before = Minimise(set, Stiffness, tip, forces);
    double excess = 0.0;
    double stretch = 0.0;
    double push = 0.0;
    for (int step = 0; step < 20000; ++step)
    {
      const Vector3 next =
        step % 100 == 0 ? dice.Place(0.01) : tip + dice(0.0, 1.0) * dice.Place(0.001);
      const PrimitiveBalance now = Minimise(set, Stiffness, next, forces);
      const double moved = Stiffness * Norm(next - tip);
      stretch = std::max(stretch, Stiffness * Norm(now.Proxy - before.Proxy) - moved);
      excess = std::max(excess, Norm(now.Force - before.Force) - moved);
      push = std::max(push, Norm(now.Force));
      tip = next;
      before = now;
    }
    EXPECT_LT(stretch, isFrame ? 1e-14 : 1e-9) << "N, round " << round;
    EXPECT_LT(excess, isFrame ? 1e-14 : 1e-9) << "N, round " << round;
    EXPECT_LE(push, most * (1.0 + 1e-14));
  }
}

TEST(Primitives, TurnWithTheirWorld)
{
  PrimitiveDice dice(6);
  for (int round = 0; round < 300; ++round)
  {
    const PrimitiveSet set = round % 2 ? dice.FrameSet(4) : dice.AnySet(3);
    const Vector3 a = dice.Direction();
    const Vector3 across = Cross(a, dice.Direction());
    const Vector3 b = (1.0 / Norm(across)) * across;
    const Matrix3 turn{ { a, b, Cross(a, b) } };
    PrimitiveSet turned;
    for (Primitive primitive : set)
    {
      primitive.Direction = turn * primitive.Direction;
      primitive.Anchor = turn * primitive.Anchor;
      turned.Add(primitive);
    }
    const Vector3 tip = dice.Place(0.01);
    PrimitiveForces forces{};
    PrimitiveForces turnedForces{};
    const PrimitiveBalance here = Minimise(set, Stiffness, tip, forces);
    const PrimitiveBalance there = Minimise(turned, Stiffness, turn * tip, turnedForces);
    EXPECT_LT(Norm(turn * here.Force - there.Force), round % 2 ? 1e-12 : 1e-9);
  }
}

TEST(Primitives, WhatIsNoPrimitiveDoesNothing)
{
  const Vector3 tip{ 0.001, 0.002, 0.003 };
  const Vector3 x{ 1.0, 0.0, 0.0 };
  const auto isNothing = [&](const Primitive& primitive)
  { return Norm(BalanceOf({ primitive }, tip).Force) == 0.0; };
  for (const PrimitiveKind kind :
    { PrimitiveKind::Force, PrimitiveKind::Point, PrimitiveKind::Line, PrimitiveKind::Plane })
  {
    const Vector3 anchor{ 1.0, 1.0, 1.0 };
    EXPECT_FALSE(isNothing({ kind, x, anchor, 1.0 }));
    for (const double strength : { 0.0, -1.0, NaN, -Infinity })
    {
      EXPECT_TRUE(isNothing({ kind, x, anchor, strength }));
    }
    const bool hasDirection = kind != PrimitiveKind::Point;
    EXPECT_EQ(isNothing({ kind, {}, anchor, 1.0 }), hasDirection);
    EXPECT_EQ(isNothing({ kind, { NaN, 0.0, 1.0 }, anchor, 1.0 }), hasDirection);
    EXPECT_EQ(isNothing({ kind, { Infinity, 0.0, 1.0 }, anchor, 1.0 }), hasDirection);
    const bool hasAnchor = kind != PrimitiveKind::Force;
    EXPECT_EQ(isNothing({ kind, x, { NaN, 0.0, 0.0 }, 1.0 }), hasAnchor);
    EXPECT_EQ(isNothing({ kind, x, { 1e300, 0.0, 0.0 }, 1.0 }), hasAnchor);
    // Directions are unit vectors, however short or long they were.
    for (const double length : { 5e-324, 1e-300, 1e300 })
    {
      const Vector3 force = BalanceOf({ { kind, length * x, anchor, 1.0 } }, tip).Force;
      EXPECT_NEAR(Norm(force), 1.0, 1e-12);
    }
  }
  EXPECT_TRUE(isNothing({ PrimitiveKind::Force, x, {}, Infinity })) << "no push without limit";
  const PrimitiveBalance held =
    BalanceOf({ { PrimitiveKind::Point, {}, {}, Infinity }, { PrimitiveKind::Force, x, {}, 1.0 } },
      { 0.5, 0.0, 0.0 });
  EXPECT_EQ(Norm(held.Proxy), 0.0) << "an infinite strength holds";
  // Springs and tips that are none.
  PrimitiveSet set;
  set.Add({ PrimitiveKind::Line, x, {}, 1.0 });
  PrimitiveForces forces;
  for (const double k : { 0.0, -1.0, NaN, Infinity })
  {
    forces.fill({ NaN, NaN, NaN });
    EXPECT_EQ(Norm(Minimise(set, k, tip, forces).Force), 0.0);
  }
  for (const double far : { NaN, Infinity, 1e200 })
  {
    EXPECT_EQ(Norm(Minimise(set, Stiffness, { far, 0.0, 0.0 }, forces).Force), 0.0);
  }
}

TEST(Primitives, ASetHoldsEight)
{
  PrimitiveSet set;
  for (int i = 0; i < PrimitiveSet::Most; ++i)
  {
    EXPECT_TRUE(set.Add({ PrimitiveKind::Point, {}, {}, i == 2 ? NaN : 1.0 }));
  }
  EXPECT_FALSE(set.Add({ PrimitiveKind::Force, { 1.0, 0.0, 0.0 }, {}, 1.0 }));
  EXPECT_EQ(set.GetSize(), PrimitiveSet::Most);
  EXPECT_EQ(set.SumStrengths(), 7.0) << "what is no primitive keeps its place, without strength";
}
