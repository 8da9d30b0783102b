// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests forces on a surface that the slow loop has fitted. The surface is at z = 12 mm, the
 * stiffness is 500 N/m, and the tick rate 1 kHz.
 */

#include "Core/State/ServoStateNumbers.h"
#include "Rigs/LocalSurfaceRig.h"
#include "Rigs/SurfaceRig.h"

using namespace coretest;

namespace
{
constexpr int Period = 17; // ticks until the slow loop (60 Hz) replies

class LocalSurfaceTick : public testing::Test
{
protected:
  const TestVolume Volume = MakeRamp();
  HapticModelDescription Description = DescribeLocal(this->Volume, 1200.0);
};
} // namespace

TEST_F(LocalSurfaceTick, HoldsTheTipAndLetsGo)
{
  Hand hand(this->Description, { 10.0, 10.0, 9.0 });
  hand.Lead({ 10.0, 10.0, 14.0 });
  EXPECT_NEAR(hand.Record.Force.Z, -1.0, 1e-6);
  EXPECT_LE(Norm(hand.Proxy() - Vector3{ 10.0, 10.0, 12.0 }), 1e-6);
  EXPECT_NEAR(hand.Record.NormalForce, 1.0, 1e-6);
  EXPECT_LE(Norm(hand.Record.Normal - Vector3{ 0.0, 0.0, 1.0 }), 1e-9);
  EXPECT_EQ(hand.Record.SurfaceValue, 1200.0);
  hand.Lead({ 14.0, 10.0, 14.0 });
  EXPECT_LE(Norm(hand.Proxy() - Vector3{ 14.0, 10.0, 12.0 }), 1e-6);
  hand.Lead({ 14.0, 10.0, 11.9 });
  EXPECT_LE(Norm(hand.Record.Force), 1e-6) << "what is left of the last renewal, by rounding";
  hand.Lead({ 14.0, 10.0, 10.0 });
  EXPECT_EQ(Norm(hand.Record.Force), 0.0);
  EXPECT_EQ(hand.Record.Contact, ContactState::Free);
}

TEST_F(LocalSurfaceTick, AnswersComeAsLateAsTheSlowLoopIsSlow)
{
  Hand hand(this->Description, { 10.0, 10.0, 11.9 });
  for (int tick = 1; tick <= 3 * Period; ++tick)
  {
    EXPECT_EQ(hand.Tick().IsRenewed, tick % Period == 0) << tick;
  }
  // The hand moves from outside to 2 mm inside in two ticks, before the first reply. No surface can
  // stop it yet.
  Hand fast(this->Description, { 10.0, 10.0, 11.0 });
  fast.Lead({ 10.0, 10.0, 14.0 }, 1.5);
  for (int tick = 0; tick < 10; ++tick)
  {
    EXPECT_EQ(Norm(fast.Tick().Force), 0.0);
  }
  // The first reply is the surface behind the hand. Its force must rise gradually.
  double last = 0.0;
  for (int tick = 0; tick < 60; ++tick)
  {
    const double force = Norm(fast.Tick().Force);
    EXPECT_GE(force, last - 1e-7);
    EXPECT_LE(force - last, 1.0 / 15.0 + 1e-9) << "1 N in 15 ms";
    last = force;
  }
  EXPECT_NEAR(last, 1.0, 1e-6);
}

TEST_F(LocalSurfaceTick, TakesOverAHandThatIsInside)
{
  HapticModelDescription before = this->Description;
  before.Settings.Method = HapticMethod::ForceField;
  this->Description.Settings.HasIsoSurface = true;
  for (const auto& [z, force] : { std::pair{ 15.0, 1.5 }, { 19.0, 0.0 } })
  {
    const HapticModel from(before);
    Hand hand(this->Description, { 10.0, 10.0, z });
    hand.State = {};
    Tick(from, hand.State, 0.001 * hand.Tip, hand.Record);
    CarryState(from, hand.Model, hand.State);
    for (int tick = 0; tick < 3 * Period; ++tick)
    {
      hand.Tick();
    }
    EXPECT_NEAR(Norm(hand.Record.Force), force, 1e-6) << z << ": 3 or 7 mm deep, 6 are in reach";
  }
}

TEST_F(LocalSurfaceTick, AStateOfNumbersGoesOnToTheBit)
{
  this->Description.Material.Friction = ConstantPolyline(0.4);
  Hand hand(this->Description, { 10.0, 10.0, 9.0 });
  hand.Lead({ 10.0, 10.3, 14.0 });
  Hand other(this->Description, {});
  other.State = FromNumbers(ToNumbers(hand.State));
  other.Tip = hand.Tip;
  for (int i = 0; i < 50; ++i)
  {
    hand.Tip.X += 0.05;
    other.Tip.X += 0.05;
    EXPECT_TRUE(IsSame(hand.Tick().Force, other.Tick().Force)) << i;
  }
}
