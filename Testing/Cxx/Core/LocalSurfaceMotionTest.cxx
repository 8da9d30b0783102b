// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * LOCAL_SURFACE under hands that go anywhere: nothing jumps, hollows hold, friction keeps to its cone.
 */

#include "LocalSurfaceRig.h"
#include "SurfaceRig.h"

using namespace coretest;

namespace
{
constexpr double Spring = 0.5; // N/mm
const Vector3 Middle{ 20.0, 20.0, 20.0 };
const LocalSurfaceShape Shapes[] = { LocalSurfaceShape::Plane, LocalSurfaceShape::Quadric };

/// A box of 16 mm whose edges are as sharp as its blur: where a quadric bends most tightly.
TestVolume MakeBox()
{
  TestVolume volume(ScalarType::Float64, { 41, 41, 41 });
  volume.Fill<double>(
    [](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      double inside = 1.0;
      for (const std::int64_t x : { i, j, k })
      {
        inside *= 0.5 * std::erfc((std::abs(double(x) - 20.0) - 8.0) / 1.4);
      }
      return 1000.0 * inside;
    });
  return volume;
}

/// Bumps and holes of some voxels.
TestVolume MakeBumps()
{
  TestVolume volume(ScalarType::Float64, { 41, 41, 41 });
  volume.Fill<double>(
    [](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const double x = double(i), y = double(j), z = double(k);
      return 500.0 +
        500.0 * std::sin(0.7 * x + std::sin(0.4 * y)) * std::cos(0.6 * y) *
        std::sin(0.5 * z + 0.3 * x);
    });
  return volume;
}

/// A hand that wanders up to 0.4 m/s. In no tick does the force change by more than it may.
void ExpectNoJump(const HapticModelDescription& description, unsigned seed)
{
  const double period = description.Settings.TickPeriod;
  const double share = period / std::max(period, description.Settings.RecoveryTime);
  std::mt19937 random(seed);
  std::normal_distribution<double> any(0.0, 1.0);
  Hand hand(description, { 20.0, 20.0, 35.0 });
  Vector3 velocity;
  double touched = 0.0;
  double longest = 0.0;
  for (int tick = 0; tick < 8000; ++tick)
  {
    const Vector3 home = Middle - hand.Tip;
    velocity =
      0.99 * velocity + 0.015 * Vector3{ any(random), any(random), any(random) } + 0.0006 * home;
    const Vector3 before = hand.Record.Force;
    hand.Tip += velocity;
    const double change = Norm(hand.Tick().Force - before) / Spring;
    longest = std::max(longest * 0.98, std::max(Norm(hand.Record.Force), Norm(before)) / Spring);
    longest = std::max(longest, Norm(hand.State.Local.Fading));
    ASSERT_LE(change, 4.0 * Norm(velocity) + 2.5 * share * longest + 1e-9) << tick;
    ASSERT_GE(hand.Record.NormalForce, 0.0);
    touched += Norm(hand.Record.Force) > 0.1 ? 1.0 : 0.0;
  }
  EXPECT_GT(touched, 100.0) << "nothing was felt";
}
} // namespace

TEST(LocalSurfaceMotion, NothingJumps)
{
  for (const TestVolume& volume : { MakeBox(), MakeBumps() })
  {
    for (const LocalSurfaceShape shape : Shapes)
    {
      for (const double friction : { 0.0, 0.4, 2.0 })
      {
        HapticModelDescription d = DescribeLocal(volume, 500.0, shape);
        d.Material.Friction = ConstantPolyline(friction);
        ExpectNoJump(d, 1);
        d.Settings.LocalSurfaceRate = 20.0;
        d.Settings.RecoveryTime = 0.1;
        ExpectNoJump(d, 2);
      }
    }
  }
}

TEST(LocalSurfaceMotion, AHollowHoldsAHandThatGrazesIt)
{
  const TestVolume volume = MakeLocalBall(-1.0);
  for (const double slide : { 0.05, 0.1, 0.2 }) // mm a tick, m/s
  {
    for (const double press : { 0.002, 0.02 })
    {
      Hand hand(DescribeLocal(volume, 100.0), Middle + Vector3{ 0.0, 0.0, BallRadius - 1.0 });
      for (int tick = 0; tick < 3000; ++tick)
      {
        const double angle = slide * tick / BallRadius;
        const double r = std::min(BallRadius - 1.0 + press * tick, BallRadius + 2.0);
        hand.Tip = Middle + r * Vector3{ std::sin(angle), 0.0, std::cos(angle) };
        hand.Tick();
      }
      EXPECT_GT(Norm(hand.Record.Force), 0.2) << slide << " " << press;
    }
  }
}

TEST(LocalSurfaceMotion, FrictionIsNoMoreThanItsShareOfTheNormalForce)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const TestVolume volume = MakeLocalBall(sign);
    HapticModelDescription d = DescribeLocal(volume, 100.0, LocalSurfaceShape::Quadric);
    d.Material.Friction = ConstantPolyline(1.0);
    const double r = BallRadius - 4.0 * sign;
    Hand hand(d, Middle + Vector3{ 0.0, 0.0, BallRadius + sign });
    hand.Lead(Middle + Vector3{ 0.0, 0.0, r }, 0.05);
    int slid = 0;
    for (int tick = 0; tick < 1500; ++tick)
    {
      const double angle = 0.001 * tick;
      hand.Tip = Middle + r * Vector3{ std::sin(angle), 0.0, std::cos(angle) };
      hand.Tick();
      const bool isSliding = hand.Record.Contact == ContactState::Sliding;
      slid += isSliding ? 1 : 0;
      if (isSliding && Norm(hand.State.Local.Fading) == 0.0)
      {
        EXPECT_LE(hand.Record.FrictionForce, hand.Record.NormalForce * (1.0 + 1e-6)) << tick;
      }
      EXPECT_NEAR(std::hypot(hand.Record.FrictionForce, hand.Record.NormalForce),
        Norm(hand.Record.Force), 1e-9);
    }
    EXPECT_GT(slid, 100);
  }
}

TEST(LocalSurfaceMotion, WhereTheKernelIsThickerThanAWallNoHandAtRestIsPulled)
{
  // A wall of one voxel, three voxels of air, and bone behind it.
  TestVolume volume(ScalarType::Float64, { 24, 24, 24 });
  volume.Fill<double>([](std::int64_t, std::int64_t, std::int64_t k)
    { return k == 10 ? 700.0 : (k > 13 ? 1500.0 : 0.0); });
  for (const LocalSurfaceShape shape : Shapes)
  {
    HapticModelDescription d = DescribeLocal(volume, 400.0, shape);
    d.Estimator = GradientEstimator::CentralDifference;
    for (double z = 6.0; z < 14.0; z += 0.05)
    {
      Hand hand(d, { 11.3, 11.7, z });
      const bool isOutside = hand.Model.ValueAtDevice(0.001 * hand.Tip) < 400.0;
      for (int tick = 0; tick < 100 && isOutside; ++tick)
      {
        ASSERT_EQ(Norm(hand.Tick().Force), 0.0) << z;
      }
    }
  }
}
