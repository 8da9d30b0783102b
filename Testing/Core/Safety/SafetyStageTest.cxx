// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the limit of the force, the slew limit, the ramp and the watchdog.
 */

#include "SafetyRig.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace servotest;

namespace
{
class Safety : public SafetyTest
{
};
} // namespace

TEST_F(Safety, ClampsTheNormAndKeepsTheDirection)
{
  this->Stage.Arm();
  const Vector3 output = this->Repeat({ 30.0, 0.0, -40.0 }, 1000);
  EXPECT_NEAR(output.X, 2.4, 1e-12);
  EXPECT_EQ(output.Y, 0.0);
  EXPECT_NEAR(output.Z, -3.2, 1e-12);
}

TEST_F(Safety, NothingLeavesWithoutAMaximum)
{
  this->Limits.MaximumForce = 0.0;
  this->Stage.Arm();
  EXPECT_TRUE(IsZero(this->Repeat({ 1.0, 1.0, 1.0 }, 1000)));
}

TEST_F(Safety, EnormousForcesStayFinite)
{
  this->Stage.Arm();
  this->Repeat({ 1e300, -1e300, 1e308 }, 1000); // Apply() checks the force of each tick
}

TEST_F(Safety, GrowsAtTheLimitAndFallsAtOnce)
{
  this->Activate({});
  for (int i = 1; i <= 8; ++i)
  {
    EXPECT_NEAR(this->Apply({ 0.0, 0.0, 4.0 }).Z, 0.5 * i, 1e-12);
  }
  EXPECT_EQ(this->Apply({ 0.0, 0.0, 0.25 }).Z, 0.25);
  EXPECT_NEAR(this->Apply({ 0.0, 0.0, 4.0 }).Z, 0.75, 1e-12) << "from where it fell to";
  EXPECT_TRUE(IsZero(this->Apply({})));
}

TEST_F(Safety, AForceThatIsReversedGrowsFromZero)
{
  this->Activate({ 0.0, 0.0, 4.0 });
  for (int i = 1; i <= 8; ++i)
  {
    const Vector3 output = this->Apply({ 0.0, 0.0, -4.0 });
    EXPECT_NEAR(output.Z, -0.5 * i, 1e-12);
  }
  EXPECT_EQ(this->Apply({ 0.0, 0.0, -4.0 }).Z, -4.0);
}

TEST_F(Safety, AForceThatTurnsKeepsItsPartAlongTheNewDirection)
{
  // After a turn by a right angle, the force starts again from zero. After a turn by 60 degrees,
  // half of the last force remains.
  this->Activate({ 0.0, 0.0, 4.0 });
  EXPECT_NEAR(this->Apply({ 4.0, 0.0, 0.0 }).X, 0.5, 1e-12);
  EXPECT_EQ(this->Output.Z, 0.0);
  this->Activate({ 0.0, 0.0, 4.0 });
  const double sine = std::sqrt(0.75);
  EXPECT_LT(Norm(this->Apply({ 4.0 * sine, 0.0, 2.0 }) - Vector3{ 2.5 * sine, 0.0, 1.25 }), 1e-12);
}

TEST_F(Safety, AForceThatTurnsSlowlyIsWhatIsWantedToTheBit)
{
  this->Limits.MaximumSpeed = 0.0;
  this->Activate({ 4.0, 0.0, 0.0 });
  for (int i = 1; i <= 720; ++i)
  {
    const double angle = i * std::acos(-1.0) / 180.0;
    const Vector3 wanted{ 3.9 * std::cos(angle), 3.9 * std::sin(angle), 0.0 };
    this->Input.Tip = 0.001 * wanted; // the tip moves along the force and across it
    const Vector3 output = this->Apply(wanted);
    ASSERT_TRUE(output.X == wanted.X && output.Y == wanted.Y) << "in tick " << i;
  }
}

TEST_F(Safety, GrowsNeverTooFastWhateverIsWanted)
{
  this->Limits.MaximumForceRate = 130.0;
  this->Activate({});
  std::mt19937_64 engine(5);
  for (int i = 0; i < 20000; ++i)
  {
    const auto draw = [&engine] { return static_cast<double>(engine() % 2001) / 100.0 - 10.0; };
    const double shift = 1e-4 * draw();
    this->Input.Tip += Vector3{ shift, -shift, 0.5 * shift };
    this->Apply({ draw(), draw(), draw() }); // Apply() checks the force of each tick
  }
}

TEST_F(Safety, RampsInOverTheRampTime)
{
  this->Limits.MaximumForceRate = 1e6;
  for (const double time : { 0.1, 0.5 })
  {
    this->Limits.RampTime = time;
    this->Stage.Arm();
    const int ticks = static_cast<int>(std::lround(time / this->Input.Period));
    for (int i = 0; i < ticks; ++i)
    {
      EXPECT_NEAR(this->Apply({ 0.0, 3.0, 0.0 }).Y, 3.0 * i / ticks, 1e-9);
    }
    EXPECT_NEAR(this->Apply({ 0.0, 3.0, 0.0 }).Y, 3.0, 1e-9);
  }
}

TEST_F(Safety, AWallThatIsPressedDuringTheRampIsSoftUntilTheTipLeavesIt)
{
  const auto press = [this](double depth)
  {
    while (std::abs(depth + this->Input.Tip.Z) > 1e-9)
    {
      this->Input.Tip.Z -= std::clamp(depth + this->Input.Tip.Z, -1e-4, 1e-4);
      this->Apply({ 0.0, 0.0, 500.0 * std::max(0.0, -this->Input.Tip.Z) });
    }
    return this->Output.Z;
  };
  this->Limits.RampTime = 0.5;
  this->Stage.Arm();
  press(3e-3);
  EXPECT_TRUE(this->Stage.IsSoft());
  this->Repeat({ 0.0, 0.0, 1.5 }, 1000);
  EXPECT_TRUE(this->Stage.IsSoft());
  EXPECT_LT(this->Output.Z, 0.9 * 1.5);
  press(-1e-3);
  EXPECT_FALSE(this->Stage.IsSoft());
  EXPECT_NEAR(press(3e-3), 1.5, 1e-9);
  EXPECT_FALSE(this->Stage.IsSoft());
}

TEST_F(Safety, StaleSamplesLeadToZeroAndRampInAgain)
{
  const Vector3 force{ 3.0, 0.0, 0.0 };
  this->Activate(force);
  this->Input.Fresh = false;
  // The last force is held until the watchdog's time has passed.
  EXPECT_EQ(Norm(this->Repeat(force, 29)), 3.0);
  EXPECT_FALSE(this->Stage.IsStale());
  this->Repeat(force, 2);
  EXPECT_TRUE(this->Stage.IsStale());
  double last = Norm(this->Output);
  EXPECT_LT(last, 3.0);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_LE(Norm(this->Apply(force)), last);
    last = Norm(this->Output);
  }
  EXPECT_EQ(last, 0.0);
  EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::None);
  EXPECT_TRUE(IsZero(this->Repeat(force, 1000)));
  EXPECT_TRUE(IsZero(this->Output));

  this->Input.Fresh = true;
  for (int i = 0; i < 500; ++i)
  {
    EXPECT_NEAR(this->Apply(force).X, 3.0 * i / 500, 1e-9);
  }
  EXPECT_FALSE(this->Stage.IsStale());
}

TEST_F(Safety, ARetreatThatHasBegunGoesOnToZeroWithoutAStep)
{
  const Vector3 force{ 3.0, 0.0, 0.0 };
  this->Activate(force);
  this->Input.Fresh = false;
  this->Repeat(force, 32);
  EXPECT_TRUE(this->Stage.IsStale());
  this->Input.Fresh = true;
  for (double last = this->Output.X; last > 0.0; last = this->Output.X)
  {
    EXPECT_NEAR(this->Apply(force).X, std::max(0.0, last - 0.5), 1e-12);
  }
  for (int i = 0; i < 500; ++i)
  {
    EXPECT_NEAR(this->Apply(force).X, 3.0 * i / 500, 1e-9);
  }
}

TEST_F(Safety, ARetreatPushesNoHandThatIsKnownToBeElsewhere)
{
  const Vector3 force{ 3.0, 0.0, 0.0 };
  for (const Vector3& wanted : { Vector3{}, Vector3{ 0.0, 3.0, 0.0 }, Vector3{ -3.0, 0.0, 0.0 },
         Vector3{ 0.5, 3.0, 0.0 }, Vector3{ 9.0, 0.0, 0.0 } })
  {
    this->Input.Fresh = true;
    this->Stage.Arm();
    this->Repeat(force, 600);
    this->Input.Fresh = false;
    this->Repeat(force, 31);
    const double left = this->Output.X;
    ASSERT_LT(left, 3.0);
    EXPECT_NEAR(this->Apply(wanted).X, left - 0.5, 1e-12) << "as long as it is not known";
    this->Input.Fresh = true;
    // The sent force has the direction of the wanted force, and continues from the last force's
    // component along that direction.
    const double along = std::max(0.0, (left - 0.5) * wanted.X);
    const double norm = along > 0.0 ? std::min(left - 1.0, along / Norm(wanted)) : 0.0;
    const Vector3 sent = this->Apply(wanted);
    EXPECT_NEAR(sent.X, norm > 0.0 ? norm * wanted.X / Norm(wanted) : 0.0, 1e-12);
    EXPECT_NEAR(sent.Y, norm > 0.0 ? norm * wanted.Y / Norm(wanted) : 0.0, 1e-12);
    EXPECT_LE(Norm(sent), Norm(wanted));
  }
  this->Stage.Arm();
  this->Repeat(force, 600);
  this->Input.Fresh = false;
  this->Repeat(force, 31);
  this->Input.Fresh = true;
  this->Stage.Gate.ReportData(0.25, ForceGate::FadeTime);
  EXPECT_NEAR(this->Apply(force).X, 0.75, 1e-12);
}

TEST_F(Safety, AGapInTheLoopItselfRampsInAgain)
{
  this->Activate({ 3.0, 0.0, 0.0 });
  this->Input.Elapsed = 0.05;
  this->Apply({ 3.0, 0.0, 0.0 });
  this->Input.Elapsed = this->Input.Period;
  EXPECT_LT(Norm(this->Repeat({ 3.0, 0.0, 0.0 }, 20)), 0.2);
  EXPECT_NEAR(Norm(this->Repeat({ 3.0, 0.0, 0.0 }, 600)), 3.0, 1e-9);
}
