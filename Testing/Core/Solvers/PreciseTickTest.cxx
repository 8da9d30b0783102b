// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the solver Precise: a motion that needs more than one tick, a model that changes under a
 * resting hand, and a stored state.
 */

#include "Core/Solvers/Precise/PreciseSolver.h"
#include "Core/Solvers/Precise/ProxyDisplacement.h"
#include "Core/State/ServoStateNumbers.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace coretest;

namespace
{
constexpr double Impenetrable = 1e9;

/// Returns air up to z = 100 mm, followed by a wall. The volume has 120 voxels of 1 mm along z.
TestVolume MakeWall()
{
  TestVolume volume(ScalarType::Float64, { 24, 24, 120 });
  volume.Fill<double>([](std::int64_t, std::int64_t, std::int64_t k)
    { return k < 100 ? 0.0 : std::min(1000.0, 100.0 * double(k - 100)); });
  return volume;
}

HapticModelDescription DescribeWall(const TestVolume& volume)
{
  HapticModelDescription description = Describe(volume);
  description.Material.SurfaceStrength = ConstantPolyline(Impenetrable);
  description.Material.Distinctness = { { 10.0, 0.0 }, { 50.0, 1.0 } };
  return description;
}
} // namespace

TEST(PreciseTick, ATeleportedTipIsFollowedInTicksAndNothingIsSkipped)
{
  const TestVolume volume = MakeWall();
  HapticModelDescription description = DescribeWall(volume);
  PlaceAsThePaper(description);
  const HapticModel model(description);
  ServoState state;
  TickRecord record;
  Tick(model, state, { 0.012, 0.012, 0.001 }, record);
  // Move the tip a metre sideways, back, and through 100 mm of air to 18 mm inside the wall, each
  // in one tick.
  Tick(model, state, { 1.012, 0.012, 0.001 }, record);
  EXPECT_LT(Norm(record.Force), 1e-12);
  Tick(model, state, { 0.012, 0.012, 0.001 }, record);
  const Vector3 tip = { 0.012, 0.012, 0.118 };
  int late = 0;
  double before = 0.0;
  do
  {
    Tick(model, state, tip, record);
    EXPECT_LT(record.Proxy.Z, 0.101) << "it fell through";
    EXPECT_GE(Norm(record.Force), before) << "the force rises with the way that is done";
    EXPECT_LE(Norm(record.Force), 500.0 * Norm(record.Proxy - tip) * (1.0 + 1e-12));
    before = Norm(record.Force);
    ASSERT_LT(++late, 100);
  } while (record.IsUnfinished);
  EXPECT_GT(late, 1) << "that much can't be done in one tick";
  EXPECT_NEAR(Norm(record.Force), 500.0 * (tip.Z - record.Proxy.Z), 1e-9);
}

TEST(PreciseTick, AProxyOnItsWayBringsNoForceAlong)
{
  // The air has no stiffness. The wall is stiff and drags the proxy, but has no strength where it
  // begins.
  const TestVolume volume = MakeWall();
  HapticModelDescription description = DescribeWall(volume);
  PlaceAsThePaper(description);
  description.Material.Stiffness = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 1000.0 } };
  const HapticModel model(description);
  ServoState state;
  TickRecord record;
  Tick(model, state, { 0.012, 0.012, 0.095 }, record);
  // According to the stored state, the hand was inside the wall. The proxy cannot have been there,
  // so it starts from the air.
  state.Precise.ReachedTip = { 0.012, 0.012, 0.110 };
  Tick(model, state, { 0.012, 0.012, 0.110 }, record);
  EXPECT_LT(record.Proxy.Z, 0.103);
  EXPECT_LT(Norm(record.Force), 1e-3) << "the hand has not pressed";
  Tick(model, state, { 0.012, 0.012, 0.1101 }, record);
  EXPECT_NEAR(Norm(record.Force), 0.1, 2e-3) << "0.1 mm on 1000 N/m";
}

TEST(PreciseTick, StifferTissueUnderARestingHandKeepsTheForceAndSofterKeepsTheStretch)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = DescribeWall(volume);
  const HapticModel middle(description);
  description.Material.Stiffness = ConstantPolyline(2000.0);
  const HapticModel stiff(description);
  description.Material.Stiffness = ConstantPolyline(100.0);
  const HapticModel soft(description);
  ServoState state;
  TickRecord record;
  const Vector3 tip = { 0.012, 0.012, 0.0135 };
  Tick(middle, state, { 0.012, 0.012, 0.010 }, record);
  Tick(middle, state, tip, record);
  EXPECT_NEAR(Norm(record.Force), 1.75, 1e-9); // N: T15, 3.5 mm on 500 N/m
  CarryState(middle, stiff, state);
  for (int i = 0; i < 3; ++i)
  {
    Tick(stiff, state, tip, record);
    EXPECT_NEAR(Norm(record.Force), 1.75, 1e-9);
    EXPECT_NEAR(record.Stiffness, 500.0, 1e-6) << "force / distance";
    EXPECT_EQ(record.Slope, 2000.0) << "what pressing on feels";
  }
  Tick(stiff, state, tip + Vector3{ 0.0, 0.0, 0.0001 }, record);
  EXPECT_NEAR(Norm(record.Force), 1.75 + 0.2, 1e-6) << "pressing on is felt at 2000 N/m";
  Tick(stiff, state, tip, record);
  CarryState(stiff, soft, state);
  Tick(soft, state, tip, record);
  EXPECT_NEAR(Norm(record.Force), 100.0 * 1.75 / 2000.0, 1e-9);
  CarryState(soft, stiff, state);
  Tick(stiff, state, tip, record);
  EXPECT_NEAR(Norm(record.Force), 100.0 * 1.75 / 2000.0, 1e-9) << "what is lost is lost";
}

class PreciseTickState
  : public testing::TestWithParam<std::tuple<MaterialPlacement, ContactAlignment>>
{
};

TEST_P(PreciseTickState, GoesOnToTheBitIfStored)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Describe(volume);
  description.Material.Friction = ConstantPolyline(0.3);
  description.Material.Viscosity = ConstantPolyline(0.2);
  description.Material.Stiffness = { { 0.0, 300.0 }, { 2000.0, 1500.0 } };
  std::tie(description.Settings.Placement, description.Settings.Alignment) = this->GetParam();
  const HapticModel model(description);
  ServoState state;
  TickRecord a;
  TickRecord b;
  Wanderer wanderer(24.0);
  for (int i = 0; i < 2000; ++i)
  {
    ServoState stored = FromNumbers(ToNumbers(state));
    const Vector3 tip = wanderer.Next();
    Tick(model, state, tip, a);
    Tick(model, stored, tip, b);
    ASSERT_EQ(ToNumbers(state), ToNumbers(stored));
    ASSERT_EQ(Norm(a.Force - b.Force), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PreciseTickState,
  testing::Combine(testing::Values(MaterialPlacement::Kernel, MaterialPlacement::FarSide),
    testing::Values(ContactAlignment::Distinctness, ContactAlignment::Edge)));

TEST(PreciseTick, BehindATipOnALineTheProxyStaysOnTheLine)
{
  // The tip moves along z, with a lag that rounding has turned aside by 1e-17 m. A dragged proxy
  // follows a tractrix, on which the angle to the motion decreases. It must not increase for any
  // drag.
  constexpr double k = 400.0;
  constexpr double rounding = 1e-17;
  const Vector3 step = { 0.0, 0.0, 1e-4 };
  for (double drag = 1e-8; drag < 1.0; drag *= 1.7) // N
  {
    PrecisePoint here;
    here.Normal = { 0.6, 0.0, 0.8 };
    here.Stiffness = k;
    here.Friction = 0.3;
    here.Viscosity = drag;
    const double length = 0.9 * drag / k;
    for (const Vector3& lagBefore : { Vector3{ rounding, 0.0, 0.0 }, { rounding, 0.0, length } })
    {
      const Vector3 lag = lagBefore + step;
      const SplitLag split = Law::Split(lag, here.Normal);
      const auto plain = [&]
      { return Law::Move(here, k, split, Law::Weigh(here, k, split), Vector3{}); };
      const Vector3 moved = ProxyDisplacement::Compute(
        here, k, ProxyDisplacement::LongestMean, lagBefore, lag, split, plain);
      EXPECT_NEAR(lag.Z - moved.Z, std::min(lag.Z, drag / k), 1e-12 + 1e-9 * drag / k) << drag;
      EXPECT_LE(std::abs(lag.X - moved.X), 2.0 * rounding) << drag;
    }
  }
}
