// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares balances of haptic primitives with closed forms and with other algorithms: ADMM for the
 * primal problem, in long double, with the prox of each single potential and many iterations;
 * planes by trying all combinations; and large sets by the duality gap, which needs no solver.
 */

#include "Core/Solvers/Primitives/PrimitiveSolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr double Stiffness = 500.0;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Computes the balance of a set of primitives, without forces of an earlier tick.
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

/// Returns argmin |x - y|^2 / 2 + phi(x) in closed form. Positions are multiplied by the stiffness,
/// so they are in newtons.
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

/// Computes the balance by ADMM (slow reference). Sets `residual` to the largest residual of the
/// last iteration.
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

/// Solves A t = b for up to three unknowns t. Returns false if there is no solution.
bool SolveSmall(Long (&a)[3][4], int size)
{
  for (int i = 0; i < size; ++i)
  {
    int pivot = i;
    for (int r = i; r < size; ++r)
    {
      pivot = std::abs(a[r][i]) > std::abs(a[pivot][i]) ? r : pivot;
    }
    if (std::abs(a[pivot][i]) < 1e-9L)
    {
      return false;
    }
    std::swap(a[i], a[pivot]);
    for (int r = 0; r < size; ++r)
    {
      const Long fraction = r == i ? 0 : a[r][i] / a[i][i];
      for (int k = i; k <= size; ++k)
      {
        a[r][k] -= r == i ? 0 : fraction * a[i][k];
      }
    }
  }
  for (int i = 0; i < size; ++i)
  {
    a[i][size] /= a[i][i];
  }
  return true;
}

/**
 * Returns the force (N) of planes: with t_i the force of each, it minimises
 *
 *   |sum t_i q_i|^2 / 2 + sum t_i q_i.k (y - c_i)   for t_i in [0, s_i].
 *
 * Tries each t_i at its lower end, at its upper end, and between both, where its slope is 0; if
 * more than three are between, three of them give the same sum. The trial that violates the
 * Kuhn-Tucker conditions least is the minimum. Sets `violation` to its violation.
 */
Vector3 TryAllPlanes(const PrimitiveSet& set, const Vector3& tip, Long& violation)
{
  const int n = set.GetSize();
  std::vector<Long3> q(n);
  std::vector<Long> b(n);
  int trials = 1;
  for (int i = 0; i < n; ++i)
  {
    q[i] = ToLong(set[i].Direction);
    b[i] = Stiffness * Inner(ToLong(tip) - ToLong(set[i].Anchor), q[i]);
    trials *= 3;
  }
  violation = 1e30L;
  Long3 best{};
  for (int trial = 0; trial < trials && violation > 1e-17L; ++trial)
  {
    Long3 sum{};
    int state[PrimitiveSet::Most];
    int between[PrimitiveSet::Most];
    int count = 0;
    for (int i = 0, digits = trial; i < n; ++i, digits /= 3)
    {
      state[i] = digits % 3;
      between[count] = i;
      count += state[i] == 2 ? 1 : 0;
      sum = state[i] == 1 ? sum + Long(set[i].Strength) * q[i] : sum;
    }
    if (count > 3)
    {
      continue;
    }
    Long a[3][4];
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; j < count; ++j)
      {
        a[i][j] = Inner(q[between[i]], q[between[j]]);
      }
      a[i][count] = -(b[between[i]] + Inner(q[between[i]], sum));
    }
    if (!SolveSmall(a, count))
    {
      continue;
    }
    Long worst = 0;
    for (int i = 0; i < count; ++i)
    {
      const Long t = a[i][count];
      sum = sum + t * q[between[i]];
      worst = std::max({ worst, -t, t - Long(set[between[i]].Strength) });
    }
    for (int i = 0; i < n; ++i)
    {
      const Long slope = b[i] + Inner(q[i], sum);
      worst = std::max(worst, state[i] == 0 ? -slope : state[i] == 1 ? slope : Long(0));
    }
    if (worst < violation)
    {
      violation = worst;
      best = sum;
    }
  }
  return { double(best.X[0]), double(best.X[1]), double(best.X[2]) };
}

/// Returns the component of a vector across a line's direction, which the line holds. Divides by
/// the direction's squared length, which is 1 up to rounding.
Long3 AcrossLine(const Primitive& p, const Long3& v)
{
  const Long3 q = ToLong(p.Direction);
  return v - (Inner(v, q) / Inner(q, q)) * q;
}

/// Returns the force nearest to a given one among all forces that a primitive can have.
Long3 NearestForce(const Primitive& p, const Long3& force)
{
  const Long3 q = ToLong(p.Direction);
  const Long along = Inner(force, q);
  const Long s = p.Strength;
  if (p.Kind == PrimitiveKind::Plane)
  {
    return std::clamp(along, Long(0), s) * q;
  }
  const Long3 turning = p.Kind == PrimitiveKind::Line ? AcrossLine(p, force) : force;
  return std::min(Long(1), s / std::sqrt(Inner(turning, turning))) * turning;
}

/**
 * Returns an upper bound (N) of the error of the total force of primitives without pushes. For
 * forces l_i that the primitives can have, the primal function minus the dual function is the sum
 * of phi_i(r_i) + l_i.r_i, with r_i = k (x - c_i). The primal function is |w|^2 / 2 plus a convex
 * function, so |w - w*|^2 is at most twice this difference.
 */
double BoundError(const PrimitiveSet& set, const Vector3& tip, const PrimitiveForces& forces)
{
  std::vector<Long3> possible;
  Long3 sum{};
  Long3 all{};
  for (int i = 0; i < set.GetSize(); ++i)
  {
    const Long3 force = ToLong(forces[static_cast<std::size_t>(i)]);
    possible.push_back(NearestForce(set[i], force));
    sum = sum + possible.back();
    all = all + force;
  }
  Long gap = 0;
  for (int i = 0; i < set.GetSize(); ++i)
  {
    const Primitive& p = set[i];
    const Long3 r = Long(Stiffness) * (ToLong(tip) - ToLong(p.Anchor)) + sum;
    const Long3 away = p.Kind == PrimitiveKind::Line ? AcrossLine(p, r) : r;
    const Long distance = p.Kind == PrimitiveKind::Plane
      ? std::max(Long(0), -Inner(r, ToLong(p.Direction)))
      : std::sqrt(Inner(away, away));
    gap += Long(p.Strength) * distance + Inner(possible[static_cast<std::size_t>(i)], r);
  }
  const Long3 off = all - sum;
  return double(std::sqrt(2 * std::max(Long(0), gap)) + std::sqrt(Inner(off, off)));
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
  /// Returns random primitives, each with its own anchor.
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
  /// Returns primitives like those of a composition, with one anchor, and directions along the axes
  /// of one frame.
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
  /// Returns random primitives with one anchor, like those of several modes at a place. Two of
  /// three are parallel or perpendicular to the first one.
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

  enum class Anchors
  {
    Common,
    OfPairs,
    Own
  };
  /// Returns pairs of opposed planes, like those of two-sided modes, followed by other primitives.
  PrimitiveSet OpposedSet(int pairs, std::vector<PrimitiveKind> others, Anchors anchors)
  {
    const Vector3 common = this->Place(0.004);
    const auto anchor = [&] { return anchors == Anchors::Common ? common : this->Place(0.004); };
    PrimitiveSet set;
    for (int i = 0; i < pairs; ++i)
    {
      const Vector3 q = this->Direction();
      const Vector3 at = anchor();
      const double strength = (*this)(0.0, 2.0);
      set.Add({ PrimitiveKind::Plane, q, at, strength });
      set.Add({ PrimitiveKind::Plane, -q, anchors == Anchors::Own ? anchor() : at,
        this->Engine() % 2 ? strength : (*this)(0.0, 2.0) });
    }
    for (const PrimitiveKind kind : others)
    {
      set.Add({ kind, this->Direction(), anchor(), (*this)(0.0, 2.0) });
    }
    return set;
  }

private:
  std::mt19937_64 Engine;
};
} // namespace

TEST(Primitives, ALineLeavesItsDirectionFreeAndYieldsAcrossIt)
{
  // P1: a line with a strength of 2 N and a stiffness of 500 N/m holds the proxy up to 4 mm.
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
  // P2: a constant force moves the proxy by the force divided by the stiffness.
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
    if (round < 3) // P10: a line, and an oblique plane of 1 N
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
    // The descent must find the same balance from other starting forces.
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

// The five directions depend on each other, so the forces change slowly from sweep to sweep.
TEST(Primitives, OpposedPlanesAreBalancedFromAColdStart)
{
  PrimitiveDice dice(1);
  for (const PrimitiveDice::Anchors anchors : { PrimitiveDice::Anchors::Common,
         PrimitiveDice::Anchors::OfPairs, PrimitiveDice::Anchors::Own })
  {
    double worst = 0.0;
    int unfinished = 0;
    for (int round = 0; round < 20000; ++round)
    {
      const PrimitiveSet set = dice.OpposedSet(2, { PrimitiveKind::Plane }, anchors);
      const Vector3 tip = dice.Place(0.012);
      Long violation = 1;
      const Vector3 expected = TryAllPlanes(set, tip, violation);
      ASSERT_LT(violation, 1e-15L);
      PrimitiveForces forces{};
      const PrimitiveBalance balance = Minimise(set, Stiffness, tip, forces);
      worst = std::max(worst, Norm(balance.Force - expected));
      unfinished += balance.IsUnfinished;
    }
    EXPECT_LT(worst, 1e-9) << "N";
    EXPECT_EQ(unfinished, 0);
  }
}

TEST(Primitives, BalancesAreThoseThatTheDualityGapAllows)
{
  using Kinds = std::vector<PrimitiveKind>;
  constexpr PrimitiveKind point = PrimitiveKind::Point;
  constexpr PrimitiveKind line = PrimitiveKind::Line;
  constexpr PrimitiveKind plane = PrimitiveKind::Plane;
  const std::pair<int, Kinds> sets[] = { { 1, { line } }, { 2, { line } }, { 1, { point } },
    { 2, { point } }, { 1, { line, line } }, { 1, { line, point } }, { 2, { plane } },
    { 1, { plane, plane, plane } }, { 0, { line, line, line, line } },
    { 0, { line, point, plane, plane } } };
  PrimitiveDice dice(2);
  for (const PrimitiveDice::Anchors anchors :
    { PrimitiveDice::Anchors::Common, PrimitiveDice::Anchors::Own })
  {
    for (const auto& [pairs, others] : sets)
    {
      double worst = 0.0;
      for (int round = 0; round < 20000; ++round)
      {
        const PrimitiveSet set = dice.OpposedSet(pairs, others, anchors);
        const Vector3 tip = dice.Place(0.012);
        PrimitiveForces forces{};
        Minimise(set, Stiffness, tip, forces);
        worst = std::max(worst, BoundError(set, tip, forces));
      }
      // BoundError() is the root of a rounding error, for strengths of about 1 N. True errors are
      // smaller.
      EXPECT_LT(worst, 1e-3) << "N, " << pairs << " pairs and " << others.size();
    }
  }
}

TEST(Primitives, YieldingALittleIsFoundAsWell)
{
  // The tip is 0.01 mm farther away than the strengths hold, which is a typical distance in a tick.
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
    // Any expected direction must lead to the balance. The right direction usually leads to it
    // without a sweep.
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
    // A pull slightly weaker than the sum of all strengths does not move the proxy.
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
  // 1.4 million steps of a tip. Each kind of set gets as many steps as its solver makes in some
  // seconds.
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
    // Directions of any length are normalised.
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
  // Springs and tips with invalid values.
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
