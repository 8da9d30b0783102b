// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the force fades, and the proxy moves with the tip, while data are missing. When the
 * data have returned, the force must return as slowly.
 */

#include "RegionRig.h"
#include "Rigs/GatedStage.h"
#include "Rigs/Growth.h"

#include <cmath>

using namespace servotest;

namespace
{
constexpr double Period = 1e-3;
constexpr double LargestShareStep = Period / ForceGate::FadeTime * (1.0 + 1e-9);

class RegionFade : public testing::TestWithParam<MethodCase>
{
protected:
  RegionFade()
  {
    this->Limits.MaximumForce = 8.0;
    this->Limits.MaximumForceRate = 500.0;
    this->Model = this->MakeRegion(TipOf(0), 24);
    this->Stage.Arm();
    this->Walk(Outside, Outside, 600); // waits outside until the ramp has ended
    this->Walk(Outside, TipOf(0), 100);
    this->Walk(TipOf(0), TipOf(0), 100); // rests with the tip pressed into the surface
  }
  /// Runs a tick as the loop does. Expects that the command obeys the slew limit, and that the
  /// gate's opening changes by at most its largest step.
  void Step(const Vector3& tip)
  {
    const double share = this->Stage.Gate.GetOpening();
    this->Servo.Tick(*this->Model, this->State, tip, Period, this->Record,
      LocalSurfaceResult::Simulated(), this->Stage.Gate);
    EXPECT_LE(std::abs(this->Stage.Gate.GetOpening() - share), LargestShareStep);
    SafetyInput input;
    input.Force = this->Record.Force;
    input.Tip = tip;
    input.Elapsed = Period;
    input.Fresh = true;
    const Vector3 before = this->Command;
    this->Command = this->Stage.Apply(input, this->Limits);
    EXPECT_LE(
      GrowthOf(before, this->Command), this->Limits.MaximumForceRate * Period * (1.0 + 1e-9));
    EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::None);
  }
  void Walk(const Vector3& from, const Vector3& to, int ticks)
  {
    for (int i = 1; i <= ticks; ++i)
    {
      this->Step(from + (double(i) / ticks) * (to - from));
    }
  }
  std::shared_ptr<const HapticModel> MakeRegion(const Vector3& tip, std::int64_t half)
  {
    HapticModelDescription d = CropAround(this->Whole, tip, half);
    d.Number = this->Model ? this->Model->Baked->Number : 0;
    return std::make_shared<const HapticModel>(d);
  }

  const Vector3 Outside = (26.0 / 23.4) * TipOf(0);
  HapticModelDescription Whole =
    DescribeBall(this->GetParam().Method, this->GetParam().Solver, this->GetParam().Placement);
  std::shared_ptr<const HapticModel> Model;
  ServoState State;
  ResidentServo Servo;
  TickRecord Record;
  rigs::GatedStage Stage;
  SafetyLimits Limits;
  Vector3 Command;
};
} // namespace

TEST_P(RegionFade, ATipThatTravelsInTheDarkComesBackWithoutAStep)
{
  const Vector3 here = TipOf(0);
  const Vector3 there = here + 1e-3 * Vector3{ 0.0, 0.0, 40.0 };
  EXPECT_EQ(this->Stage.Gate.GetOpening(), 1.0);
  const double pressed = Norm(this->Command);
  EXPECT_GT(pressed, 0.1);
  this->Walk(here, there, 200);
  EXPECT_EQ(this->Stage.Gate.GetOpening(), 0.0);
  EXPECT_TRUE(this->Servo.IsAwaiting());
  EXPECT_EQ(Norm(this->Command), 0.0);
  EXPECT_TRUE(IsSame(this->Record.Proxy, there)) << "the proxy went along";
  // Load the region around the tip, which is just outside the ball. In the first tick with this
  // region, the force is still zero.
  const auto next = this->MakeRegion(there, 24);
  CarryState(*this->Model, *next, this->State);
  this->Model = next;
  this->Step(there);
  EXPECT_LT(Norm(this->Command), 1e-9);
  // Return to the first region's position. That region has to be loaded again.
  this->Walk(there, here, 200);
  EXPECT_EQ(Norm(this->Command), 0.0);
  const auto last = this->MakeRegion(here, 24);
  CarryState(*this->Model, *last, this->State);
  this->Model = last;
  this->Walk(here, Outside, 100);
  this->Walk(Outside, here, 100);
  this->Walk(here, here, 100);
  EXPECT_EQ(this->Stage.Gate.GetOpening(), 1.0);
  EXPECT_NEAR(Norm(this->Command), pressed, 0.2 * pressed) << "felt as before";
}

TEST_P(RegionFade, ARegionThatIsElsewhereEndsWhatIsFelt)
{
  const double pressed = Norm(this->Record.Force);
  const auto other = this->MakeRegion(-1.0 * TipOf(0), 10);
  CarryState(*this->Model, *other, this->State);
  this->Model = other;
  for (int i = 0; i < 49; ++i)
  {
    this->Step(TipOf(0));
    EXPECT_NEAR(Norm(this->Record.Force), pressed, 1e-12) << "fades by its share alone";
    EXPECT_GT(this->Stage.Gate.GetOpening(), 0.0);
  }
  this->Walk(TipOf(0), TipOf(0), 3);
  EXPECT_EQ(this->Stage.Gate.GetOpening(), 0.0);
  EXPECT_EQ(Norm(this->Record.Force), 0.0);
}

TEST_P(RegionFade, AFadeOrAHoldWithTheDataThereWaitsForNone)
{
  const auto expectNoWait = [this](double opening)
  {
    for (int i = 0; i < 200; ++i)
    {
      this->Step(TipOf(0));
      ASSERT_FALSE(this->Servo.IsAwaiting()) << "in tick " << i;
    }
    EXPECT_EQ(this->Stage.Gate.GetOpening(), opening);
  };
  this->Stage.Gate.FadeOut();
  expectNoWait(1.0); // the gate closes and opens again without force
  EXPECT_FALSE(this->Stage.Gate.IsOpen());
  this->Stage.Arm();
  expectNoWait(1.0);
  this->Stage.Gate.SetHeld(true);
  expectNoWait(0.0);
  this->Stage.Gate.SetHeld(false);
  expectNoWait(1.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, RegionFade, testing::ValuesIn(MethodCases), NameOf);
