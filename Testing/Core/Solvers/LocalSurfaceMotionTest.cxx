// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the force of the method LocalSurface never jumps under hands that move at random.
 */

#include "Rigs/LocalSurfaceRig.h"
#include "Rigs/SurfaceRig.h"

using namespace coretest;

namespace
{
constexpr double Spring = 0.5; // N/mm
const Vector3 Middle{ 20.0, 20.0, 20.0 };
const LocalSurfaceShape Shapes[] = { LocalSurfaceShape::Plane, LocalSurfaceShape::Quadric };

/// Returns a box of 16 mm, with edges as sharp as the blur allows. A quadric surface bends most
/// there.
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

/// Returns a surface with bumps and holes of several voxels.
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

/// Moves a hand at random at up to 0.4 m/s. Expects that each tick changes the force by at most the
/// allowed step.
void ExpectNoJump(const HapticModelDescription& description, unsigned seed)
{
  const double period = description.Settings.TickPeriod;
  const double fraction = period / std::max(period, description.Settings.RecoveryTime);
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
    ASSERT_LE(change, 4.0 * Norm(velocity) + 2.5 * fraction * longest + 1e-9) << tick;
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

TEST(LocalSurfaceMotion, RoundABallAQuadricIsNearerThanAPlaneAndBothAreSmooth)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const TestVolume volume = MakeLocalBall(sign);
    double worst[2];
    for (const LocalSurfaceShape shape : Shapes)
    {
      const double r = BallRadius - 1.0 * sign;
      Hand hand(DescribeLocal(volume, 100.0, shape),
        Middle + (BallRadius + 2.0 * sign) * Vector3{ 0, 0, 1 });
      hand.Lead(Middle + r * Vector3{ 0.0, 0.0, 1.0 }, 0.05);
      double& off = worst[static_cast<int>(shape)];
      off = 0.0;
      Vector3 force = hand.Record.Force;
      for (int i = 0; i < 1200; ++i)
      {
        const double angle = 0.006 * i; // 0.08 m/s
        hand.Tip =
          Middle + r * Vector3{ 0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle) };
        hand.Tick();
        off = std::max(off, std::abs(Norm(hand.Proxy() - Middle) - BallRadius));
        EXPECT_LE(Norm(hand.Record.Force - force), 0.02) << "of 0.5 N; tick " << i;
        force = hand.Record.Force;
      }
    }
    EXPECT_LT(worst[1], 0.03) << sign;
    EXPECT_LT(worst[1], 0.2 * worst[0]) << sign;
  }
}
