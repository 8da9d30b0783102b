// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the method LocalSurface on shapes that are not flat: friction must stay within its cone,
 * hollows must hold the tip, and thin walls must not pull.
 */

#include "Rigs/LocalSurfaceRig.h"
#include "Rigs/SurfaceRig.h"

using namespace coretest;

namespace
{
const Vector3 Middle{ 20.0, 20.0, 20.0 };
} // namespace

TEST(LocalSurfaceShapes, FrictionSticksAndSlides)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription d = DescribeLocal(volume, 1200.0);
  d.Material.Friction = ConstantPolyline(0.4);
  Hand hand(d, { 10.0, 10.0, 9.0 });
  hand.Lead({ 10.0, 10.0, 15.0 });
  // The proxy sticks while the lateral lag is less than mu times the depth (T4 and T5 in
  // Documentation/evaluation.md).
  hand.Lead({ 11.1, 10.0, 15.0 });
  EXPECT_EQ(hand.Record.Contact, ContactState::Sticking);
  EXPECT_LE(Norm(hand.Proxy() - Vector3{ 10.0, 10.0, 12.0 }), 1e-6);
  EXPECT_NEAR(hand.Record.FrictionForce, 0.55, 1e-6);
  hand.Lead({ 15.0, 10.0, 15.0 });
  EXPECT_EQ(hand.Record.Contact, ContactState::Sliding);
  EXPECT_LE(Norm(hand.Proxy() - Vector3{ 13.8, 10.0, 12.0 }), 1e-6);
  EXPECT_NEAR(hand.Record.FrictionForce, 0.6, 1e-6);
  EXPECT_NEAR(hand.Record.Force.Z, -1.5, 1e-6);
  hand.Lead({ 13.8, 10.0, 15.0 });
  EXPECT_NEAR(hand.Record.FrictionForce, 0.0, 1e-6);
}

TEST(LocalSurfaceShapes, FrictionIsNoMoreThanItsShareOfTheNormalForce)
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

TEST(LocalSurfaceShapes, AHollowHoldsAHandThatGrazesIt)
{
  const TestVolume volume = MakeLocalBall(-1.0);
  for (const double slide : { 0.05, 0.1, 0.2 }) // mm per tick, which is m/s
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

TEST(LocalSurfaceShapes, WhereTheKernelIsThickerThanAWallNoHandAtRestIsPulled)
{
  // A wall of one voxel, then three voxels of air, then bone.
  TestVolume volume(ScalarType::Float64, { 24, 24, 24 });
  volume.Fill<double>([](std::int64_t, std::int64_t, std::int64_t k)
    { return k == 10 ? 700.0 : (k > 13 ? 1500.0 : 0.0); });
  for (const LocalSurfaceShape shape : { LocalSurfaceShape::Plane, LocalSurfaceShape::Quadric })
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
