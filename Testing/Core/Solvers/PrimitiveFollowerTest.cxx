// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares proxies that follow analytic flows with the flows' streamlines, and with the balance of
 * spring and strength. Voxels are 1 mm, so a step is at most 0.25 mm.
 */

#include "Core/Solvers/Primitives/PrimitiveFollower.h"

#include <gtest/gtest.h>

#include <limits>

using namespace VolumeHaptics;

namespace
{
constexpr double SpringOf = 500.0; // N/m
constexpr double QuarterVoxel = 0.25e-3;
constexpr double Millimetre = 1e-3;
const double FullTurn = 2.0 * std::acos(-1.0);

using FlowAt = Vector3 (*)(const Vector3&);
using StrengthAt = double (*)(const Vector3&);

/// A field with a line primitive along a flow, and the line's strength (N). Positions are in
/// metres.
struct AnalyticFlow
{
  FlowAt Flow;
  StrengthAt Strength = [](const Vector3&) { return 2.0; };

  PrimitiveField Field() const
  {
    return { [](const void* context, const Vector3& place, PrimitiveSet& set) noexcept
      {
        const auto& flow = *static_cast<const AnalyticFlow*>(context);
        set.Add({ PrimitiveKind::Line, flow.Flow(place), place, flow.Strength(place) });
      },
      this };
  }
};

/// A proxy that follows a tip through a flow, and the forces of its last tick.
class LedProxy
{
public:
  LedProxy(const AnalyticFlow& flow, const Vector3& start)
    : Flow(flow)
  {
    this->Motion.Proxy = start;
  }

  /// Runs one tick, and expects that the solver finishes in the tick.
  void Move(const Vector3& tip)
  {
    this->Motion = SolvePrimitives(
      this->Flow.Field(), SpringOf, QuarterVoxel, this->Motion.Proxy, tip, this->Memory);
    ASSERT_FALSE(this->Motion.IsUnfinished);
    // In its last step, the solver moves the proxy without computing the force again.
    EXPECT_LT(Norm(this->Motion.Force - SpringOf * (this->Motion.Proxy - tip)), 1e-4);
  }

  PrimitiveMotion Motion;

private:
  const AnalyticFlow& Flow;
  PrimitiveMemory Memory;
};

Vector3 OnCircle(double radius, double angle)
{
  return { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
}

Vector3 TurnAround(const Vector3& x)
{
  return { -x.Y, x.X, 0.0 };
}
} // namespace

TEST(PrimitiveFollower, AStreamlineIsKeptOverAHundredTurns)
{
  // P4: the tip moves on a circle of 18 mm, and pulls with 1 N on the proxy, which is on the
  // streamline of 20 mm. A step along the tangent would move the proxy to 20.4 mm.
  const AnalyticFlow flow{ TurnAround };
  for (const int ticks : { 1000, 100 })
  {
    LedProxy proxy(flow, OnCircle(20.0 * Millimetre, 0.0));
    for (int tick = 0; tick <= 100 * ticks; ++tick)
    {
      proxy.Move(OnCircle(18.0 * Millimetre, FullTurn * tick / ticks));
    }
    EXPECT_NEAR(Norm(proxy.Motion.Proxy), 20.0 * Millimetre, 0.001 * Millimetre);
    EXPECT_NEAR(Norm(proxy.Motion.Force), 1.0, 0.0005);
    EXPECT_NEAR(proxy.Motion.Proxy.Y, 0.0, 1e-4 * Millimetre) << "it is beside the tip";
  }
}

TEST(PrimitiveFollower, ADipolesLineIsKept)
{
  // P7: the proxy follows the dipole's line r = C sin^2(theta), from the equator to theta = 34
  // degrees. The tip is 5 % inside of the line.
  const AnalyticFlow flow{ [](const Vector3& x)
    {
      const double square = Dot(x, x);
      const Vector3 axis{ 0.0, 0.0, 1.0 };
      return (3.0 * x.Z) * x - square * axis;
    } };
  const double constant = 20.0 * Millimetre;
  const auto onLine = [&](double theta)
  {
    const double r = constant * std::sin(theta) * std::sin(theta);
    return Vector3{ r * std::sin(theta), 0.0, r * std::cos(theta) };
  };
  LedProxy proxy(flow, onLine(FullTurn / 4.0));
  for (int tick = 0; tick <= 1000; ++tick)
  {
    const double theta = FullTurn / 4.0 - tick / 1000.0 * (56.0 / 360.0 * FullTurn);
    proxy.Move(0.95 * onLine(theta));
    const Vector3& x = proxy.Motion.Proxy;
    const double r = Norm(x);
    const double sine = x.X / r;
    ASSERT_NEAR(r / (sine * sine), constant, 0.001 * Millimetre);
  }
  EXPECT_GT(proxy.Motion.Proxy.Z, 5.0 * Millimetre) << "it has followed";
}

TEST(PrimitiveFollower, YieldsWhereTheSpringIsTheStrengthOfThePlace)
{
  // P3: Poiseuille flow along z with a strength of S = 2 (1 - r^2/R^2) N. A tip at the radius r + 4
  // (1 - r^2/400) mm holds the proxy at the radius r (mm).
  const AnalyticFlow flow{ [](const Vector3&) {
                            return Vector3{ 0.0, 0.0, 1.0 };
                          },
    [](const Vector3& x) { return 2.0 * (1.0 - (x.X * x.X + x.Y * x.Y) / (0.02 * 0.02)); } };
  const auto pull = [&](double step)
  {
    LedProxy proxy(flow, {});
    double next = 5.0;
    for (double tip = 0.0; tip < 19.0; tip += step)
    {
      proxy.Move({ 0.6 * tip * Millimetre, 0.8 * tip * Millimetre, 0.3 * tip * Millimetre });
      if (tip >= next)
      {
        // Solve tip = r + 4 (1 - r^2/400) for r (mm).
        const double r = 50.0 - std::sqrt(2500.0 - 100.0 * (tip - 4.0));
        const Vector3& x = proxy.Motion.Proxy;
        EXPECT_NEAR(std::hypot(x.X, x.Y) / Millimetre, r, 1e-4);
        EXPECT_NEAR(Norm(proxy.Motion.Force), 2.0 * (1.0 - r * r / 400.0), 1e-3);
        EXPECT_NEAR(proxy.Motion.Force.Z, 0.0, 1e-12);
        next += 1.0;
      }
    }
    return proxy.Motion;
  };
  pull(0.05);
  pull(1.0); // so fast that a tick takes several steps
  // Tip radii (mm) and forces (N) in the specification's table.
  const double tips[2] = { 13.0, 16.75 };
  const double forces[2] = { 1.5, 0.875 };
  for (int i = 0; i < 2; ++i)
  {
    LedProxy proxy(flow, {});
    for (int tick = 1; tick <= 500; ++tick)
    {
      proxy.Move({ tips[i] * Millimetre * tick / 500.0, 0.0, 0.0 });
    }
    EXPECT_NEAR(proxy.Motion.Proxy.X, (10.0 + 5.0 * i) * Millimetre, 1e-4 * Millimetre);
    EXPECT_NEAR(-proxy.Motion.Force.X, forces[i], 0.005 * forces[i]);
  }
}

TEST(PrimitiveFollower, WhereStrengthRisesOutwardsItHoldsNoLessThanThat)
{
  const AnalyticFlow flow{ [](const Vector3&) {
                            return Vector3{ 0.0, 0.0, 1.0 };
                          },
    [](const Vector3& x) { return 0.5 + 100.0 * std::abs(x.X); } };
  for (const double step : { 0.02, 0.5 })
  {
    LedProxy proxy(flow, {});
    for (double tip = 0.0; tip < 15.0; tip += step)
    {
      proxy.Move({ tip * Millimetre, 0.0, 0.0 });
      // For the proxy x and the tip y, the balance is k (y - x) = 0.5 + 100 x.
      const double x = std::max(0.0, (SpringOf * tip * Millimetre - 0.5) / 600.0);
      ASSERT_NEAR(proxy.Motion.Proxy.X, x, 2e-3 * Millimetre) << "tip " << tip;
    }
  }
}

TEST(PrimitiveFollower, GoesThroughAShearWithoutJumpsAndRestsWhereFlowsMeet)
{
  // P8: shear flow v = (y, 0, 0) with a strength of 2 N min(1, |v|/10 mm).
  const AnalyticFlow flow{ [](const Vector3& x) {
                            return Vector3{ x.Y, 0.0, 0.0 };
                          },
    [](const Vector3& x) { return std::min(2.0, 200.0 * std::abs(x.Y)); } };
  LedProxy proxy(flow, { 0.0, -0.005, 0.0 });
  proxy.Move({ 0.0, -0.005, 0.0 });
  double strength = flow.Strength(proxy.Motion.Proxy);
  Vector3 force = proxy.Motion.Force;
  int crossed = 0;
  for (int tick = 1; tick <= 2000; ++tick)
  {
    proxy.Move({ 1e-3 * std::sin(0.01 * tick), -0.005 + 5e-6 * tick, 0.0 });
    const double now = flow.Strength(proxy.Motion.Proxy);
    const double most = std::abs(now - strength) + SpringOf * 1.2e-5;
    ASSERT_LE(Norm(proxy.Motion.Force - force), most) << "tick " << tick;
    ASSERT_LE(Norm(proxy.Motion.Force), now * (1.0 + 1e-3) + 1e-4);
    ASSERT_TRUE(IsFinite(proxy.Motion.Proxy));
    crossed += std::abs(proxy.Motion.Proxy.Y) < 1e-5;
    strength = now;
    force = proxy.Motion.Force;
  }
  EXPECT_GT(crossed, 0);
  EXPECT_GT(proxy.Motion.Proxy.Y, 0.001) << "it goes on on the other side";
  // Near a stagnation point, the proxy follows x y = constant and is not trapped in the middle.
  const AnalyticFlow stagnation{ [](const Vector3& x) { return Vector3{ x.X, -x.Y, 0.0 }; } };
  LedProxy led(stagnation, { 0.005, 0.02, 0.0 });
  for (int tick = 0; tick <= 500; ++tick)
  {
    const double x = 0.005 * std::exp(tick / 500.0 * std::log(4.0));
    led.Move({ 0.97 * x, 0.97 * 1e-4 / x, 0.0 });
    ASSERT_NEAR(led.Motion.Proxy.X * led.Motion.Proxy.Y, 1e-4, 1e-10);
  }
}

TEST(PrimitiveFollower, ATipThatTheLinesTurnAroundEndsInATick)
{
  // As in T13, the tip is on the far side of the circle's centre. Whatever path the proxy takes,
  // its steps and force must stay bounded, and it must come to rest while the tip rests.
  const AnalyticFlow flow{ TurnAround, [](const Vector3&) { return 100.0; } };
  PrimitiveMemory memory;
  PrimitiveMotion motion;
  motion.Proxy = { 0.002, 0.0, 0.0 };
  Vector3 before;
  for (int tick = 0; tick < 200; ++tick)
  {
    before = motion.Proxy;
    motion = SolvePrimitives(
      flow.Field(), SpringOf, QuarterVoxel, motion.Proxy, { -0.01, 0.0003, 0.0 }, memory);
    ASSERT_LE(motion.Steps, PrimitiveFollower::MostSteps);
    ASSERT_LE(Norm(motion.Force), 100.0);
  }
  EXPECT_FALSE(motion.IsUnfinished);
  EXPECT_LT(Norm(motion.Proxy - before), 1e-9);
  EXPECT_LT(motion.Proxy.X, 0.0) << "it has gone to the tip's side";
}

TEST(PrimitiveFollower, BadNumbersLetItGo)
{
  const AnalyticFlow flow{ TurnAround };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3 tip{ 0.01, 0.01, 0.0 };
  PrimitiveMemory memory;
  const auto follow = [&](double k, double step, const Vector3& from, const Vector3& to)
  { return SolvePrimitives(flow.Field(), k, step, from, to, memory); };
  EXPECT_EQ(Norm(follow(SpringOf, nan, {}, tip).Proxy - tip), 0.0);
  EXPECT_EQ(Norm(follow(SpringOf, 0.0, {}, tip).Proxy - tip), 0.0);
  EXPECT_EQ(Norm(follow(SpringOf, QuarterVoxel, { nan, 0.0, 0.0 }, tip).Proxy - tip), 0.0);
  for (const double k : { nan, 0.0 })
  {
    EXPECT_EQ(Norm(follow(k, QuarterVoxel, { 0.0101, 0.01, 0.0 }, tip).Force), 0.0);
  }
  EXPECT_EQ(Norm(follow(SpringOf, QuarterVoxel, {}, { nan, 0.0, 0.0 }).Force), 0.0);
  // Without a flow, no force acts.
  const AnalyticFlow none{ [](const Vector3&) { return Vector3{}; } };
  const PrimitiveMotion motion =
    SolvePrimitives(none.Field(), SpringOf, QuarterVoxel, {}, { 0.0, 0.0, 0.003 }, memory);
  EXPECT_NEAR(motion.Proxy.Z, 0.003, 1e-15);
  EXPECT_EQ(Norm(motion.Force), 0.0);
}
