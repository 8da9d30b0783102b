// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests shells in trouble: hands and data that are NaN, tools that begin inside tissue, fast hands
 * and thin walls, and shells with no points, one point or very many points.
 */

#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <limits>

using namespace coretest;

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

class ShellTrouble : public testing::Test
{
protected:
  ShellTrouble() { this->Settings.Level = 1000.0; }

  static void ExpectNothing(const ShellRecord& record)
  {
    EXPECT_EQ(Norm(record.Force), 0.0);
    EXPECT_EQ(Norm(record.Torque), 0.0);
    EXPECT_EQ(record.Contacts, 0u);
  }

  const TestVolume Volume = MakeRamp();
  HapticModelDescription Scene = Describe(this->Volume);
  ShellSettings Settings;
};
} // namespace

TEST_F(ShellTrouble, AHandThatIsNoPoseIsNotFelt)
{
  ShellHand hand(this->Scene, MakeSphere(3.0, 200), this->Settings);
  const Vector3 above{ 12.0, 12.0, 5.0 };
  const auto press = [&]()
  {
    hand.Tick(above);
    EXPECT_EQ(Norm(hand.Record.Force), 0.0) << "it begins anew";
    hand.Lead(above + Vector3{ 0.0, 0.0, 3.5 });
    EXPECT_LT(hand.Record.Force.Z, -0.1);
  };
  press();
  const Quaternion bad[] = { { 0.0, 0.0, 0.0, 0.0 }, { 1.1, 0.0, 0.0, 0.0 },
    { NotANumber, 0.0, 0.0, 0.0 }, { 0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0 } };
  for (const Quaternion& turn : bad)
  {
    ExpectNothing(hand.Tick(above, turn));
    EXPECT_FALSE(hand.State.Enabled);
    press();
  }
  for (const double x : { NotANumber, 1e300, -std::numeric_limits<double>::infinity() })
  {
    ExpectNothing(hand.Tick({ 12.0, x, 8.0 }));
    EXPECT_FALSE(hand.State.Enabled);
    press();
  }
  // A quaternion whose norm is slightly wrong, as if a sensor had rounded it.
  hand.Tick(1000.0 * hand.Record.Hand.Position, { 1.005, 0.0, 0.0, 0.0 });
  EXPECT_LT(hand.Record.Force.Z, -0.1);
}

TEST_F(ShellTrouble, NoPointFeelsNothingAndOnePointIsAPoint)
{
  ShellHand none(this->Scene, {}, this->Settings);
  none.Tick(Vector3{ 12.0, 12.0, 9.0 });
  ExpectNothing(none.Lead({ 12.0, 12.0, 13.0 }));
  EXPECT_EQ(1000.0 * none.Record.Tool.Position.Z, 1000.0 * none.Record.Hand.Position.Z);
  // A single point of 25 mm^2 has 500 N/m, like the hand's spring. The point exerts no torque.
  ShellHand one(this->Scene, { { { 0.0, 0.0, 0.0 }, 2.5e-5 } }, this->Settings);
  one.Tick(Vector3{ 12.0, 12.0, 9.0 });
  one.Lead({ 12.0, 12.0, 12.0 });
  EXPECT_NEAR(one.Rest().Force.Z, -0.5, 1e-6);
  EXPECT_EQ(Norm(one.Record.Torque), 0.0);
}

TEST_F(ShellTrouble, PointsWithoutNumbersOrAreaAreLeftOut)
{
  std::vector<ShellPoint> points = MakeSphere(2.0, 50);
  points[3].Position.Y = NotANumber;
  points[7].Area = 0.0;
  points[9].Area = -1.0;
  points[11].Area = std::numeric_limits<double>::infinity();
  const PointShell shell(points);
  EXPECT_EQ(shell.GetSize(), 46u);
  EXPECT_NEAR(shell.GetArea(), 46.0 / 50.0 * 4.0 * Pi * 4e-6, 1e-15);
  EXPECT_NEAR(shell.GetReach(), 2e-3, 1e-15);
  EXPECT_GT(shell.GetMemorySize(), 46u * 4u * sizeof(double));
}

TEST_F(ShellTrouble, AMillionPointsAreFelt)
{
  ShellHand hand(this->Scene, MakeSphere(5.0, 1000000), this->Settings);
  hand.Tick(Vector3{ 12.0, 12.0, 4.9 });
  hand.Lead({ 12.0, 12.0, 6.0 }, 0.2);
  EXPECT_LT(hand.Record.Force.Z, -0.1);
  EXPECT_LE(hand.Record.Looks, 2u) << "a tick reads no more than there is time for";
}

TEST_F(ShellTrouble, AToolThatBeginsInTissueIsFree)
{
  ShellHand hand(this->Scene, MakeSphere(3.0, 300), this->Settings);
  ExpectNothing(hand.Tick(Vector3{ 12.0, 12.0, 11.0 }));
  ExpectNothing(hand.Rest());
  ExpectNothing(hand.Lead({ 12.0, 12.0, 5.0 })); // the tool can leave the tissue
  hand.Lead({ 12.0, 12.0, 9.0 });
  EXPECT_LT(hand.Record.Force.Z, -0.1) << "and is held when it comes back";
}

/// Points near samples that are NaN must have no contact, even if all samples are NaN.
TEST_F(ShellTrouble, DataThatAreNoNumbersAreNotTouched)
{
  TestVolume holes = MakeRamp();
  holes.Fill<double>([](std::int64_t i, std::int64_t, std::int64_t k)
    { return i > 11 ? NotANumber : 100.0 * double(k); });
  HapticModelDescription scene = Describe(holes);
  ShellHand hand(scene, MakeSphere(3.0, 2000), this->Settings);
  hand.Tick(Vector3{ 8.0, 12.0, 5.0 });
  hand.Lead({ 8.0, 12.0, 8.0 });
  EXPECT_LT(hand.Record.Force.Z, -0.1);
  for (int i = 0; i < 300; ++i)
  {
    const auto& record = hand.Tick(Vector3{ 8.0 + 0.03 * i, 12.0, 8.0 });
    EXPECT_TRUE(IsFinite(record.Force) && IsFinite(record.Torque));
  }
  ExpectNothing(hand.Rest());
}

TEST_F(ShellTrouble, NothingIsTouchedOutsideTheVolume)
{
  this->Settings.IsBelow = true; // makes the values at the lower border solid
  ShellHand hand(this->Scene, MakeSphere(2.0, 200), this->Settings);
  hand.Tick(Vector3{ -9.0, 12.0, 5.0 });
  ExpectNothing(hand.Lead({ -3.0, 12.0, 5.0 }));
}

TEST_F(ShellTrouble, AnotherModelOrShellBeginsAnew)
{
  ShellHand hand(this->Scene, MakeSphere(3.0, 200), this->Settings);
  hand.Tick(Vector3{ 12.0, 12.0, 6.0 });
  hand.Lead({ 12.0, 12.0, 9.0 });
  EXPECT_LT(hand.Record.Force.Z, -0.1);
  const HapticModel other(this->Scene);
  ShellRecord record;
  const auto tick = [&](const PointShell& shell)
  {
    TickShell(other, shell, this->Settings, hand.Record.Hand, hand.State, hand.Memory, record);
    ExpectNothing(record);
  };
  tick(hand.Shell);
  EXPECT_FALSE(hand.State.Enabled);
  tick(hand.Shell);
  EXPECT_TRUE(hand.State.Enabled);
  const PointShell larger(MakeSphere(3.0, 300));
  tick(larger);
  EXPECT_FALSE(hand.State.Enabled);
}

/// A wall of two voxels has an unlimited strength. No tool may fall through it, at any speed of the
/// hand.
TEST_F(ShellTrouble, AFastToolDoesNotFallThroughAThinWall)
{
  TestVolume wall(ScalarType::Int16, { 32, 32, 48 });
  wall.Fill<std::int16_t>([](std::int64_t, std::int64_t, std::int64_t k)
    { return static_cast<std::int16_t>(k == 24 || k == 25 ? 2000 : 0); });
  HapticModelDescription scene = Describe(wall);
  scene.Material.SurfaceStrength = ConstantPolyline(1e6);
  // As in S3, but the hand is 4.5 mm deep. The tool is then 2.4 mm deep, which is more than the
  // wall's thickness.
  const double b = 500.0 / (Pi * Kappa * 3e-3);
  const double delta = 0.5 * (std::sqrt(b * b + 4.0 * b * 4.5e-3) - b);
  const double expected = 500.0 * (4.5e-3 - delta);
  EXPECT_GT(delta, 2e-3);
  std::mt19937_64 engine(17);
  for (const double speed : { 0.1, 1.0, 3.0 }) // mm per tick, which is m/s
  {
    for (int i = 0; i < 5; ++i)
    {
      ShellHand hand(scene, MakeSphere(3.0, 1000), this->Settings);
      const Quaternion turn = RandomTurn(engine);
      const Vector3 at = Vector3{ 15.5, 15.5, 18.0 } + RandomIn(engine, 2.0);
      hand.Tick(at, turn);
      hand.Lead({ at.X, at.Y, 25.0 }, speed, turn);
      EXPECT_NEAR(hand.Rest(60).Force.Z, -expected, 0.06 * expected) << "at " << speed << " m/s";
    }
  }
}
