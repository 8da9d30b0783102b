// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests walls that are stiffer than the loop can render stably without help.
 *
 * Theory: a sampled spring with a viscous friction b is passive up to K = 2 b / T (Colgate and
 * Schenkel 1997), and with encoder steps q and dry friction f up to 2 f / q (Abbott and Okamura
 * 2005). The test computes the energies exactly from the arm, not from the account.
 */

#include "Rigs/StiffWalls.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace rigs;

namespace
{
/**
 * Slew limit (N/s). It equals the rate of a press at 0.5 m/s into 6000 N/m, so it does not limit
 * hits at up to 0.1 m/s.
 */
constexpr double FastRate = 3000.0;

std::vector<StiffPress> MakePresses(double gain, bool augments)
{
  std::vector<StiffPress> presses;
  for (const bool isHeld : { false, true })
  {
    for (const double force : { 1.0, 2.0 })
    {
      for (const double speed : { 0.02, 0.1 })
      {
        presses.push_back({ isHeld, force, speed, gain, augments, FastRate });
      }
    }
  }
  return presses;
}

std::string Describe(const StiffArm& arm, const StiffPress& press)
{
  return std::string(arm.Name) + (press.IsHeld ? ", held, " : ", a weight, ") +
    std::to_string(press.Force) + " N, " + std::to_string(press.Speed) + " m/s";
}
} // namespace

TEST(StiffWalls, ArePassiveUpToWhatTheorySaysOfASampledSpring)
{
  for (StiffArm arm : { StiffArm::FalconLike(), StiffArm::TouchLike() })
  {
    arm.Step = 0.0;
    arm.Friction = 0.0;
    for (const StiffPress& press : MakePresses(0.95, false))
    {
      EXPECT_LE(PressStiffly(arm, press).Ratio, 1.0) << Describe(arm, press);
    }
    for (const StiffPress& press : MakePresses(2.0, false))
    {
      // Check only presses by the weight of 1 N alone, without a hand. With 2 N, MaximumForce
      // limits the wall's force.
      if (!press.IsHeld && press.Force == 1.0)
      {
        EXPECT_GT(PressStiffly(arm, press).Ratio, 1.0) << Describe(arm, press);
      }
    }
  }
}

TEST(ForceAugmentation, ShowsFiveTimesTheStiffnessAndGivesNoEnergy)
{
  for (const StiffArm& arm : { StiffArm::FalconLike(), StiffArm::TouchLike() })
  {
    for (const StiffPress& press : MakePresses(6.0, true))
    {
      SCOPED_TRACE(Describe(arm, press));
      ASSERT_LE(press.Gain * arm.Sampled(), 2.0 * arm.Friction / arm.Step);
      const StiffResult result = PressStiffly(arm, press);
      EXPECT_GE(result.Shown, 5.0 * arm.Sampled());
      EXPECT_LE(result.Ratio, 1.0);
      EXPECT_EQ(result.MostGiven, 0.0) << "J, at any time";
      EXPECT_LE(result.MostWithoutFriction, VolumeHaptics::ForceAugmentation::Tolerance);
      EXPECT_LE(result.Swing, 2e-4) << "m; the tremor is 1e-4";
      EXPECT_FALSE(result.IsCut);
    }
  }
}

TEST(ForceAugmentation, GivesNoMoreThanItsTolerance)
{
  constexpr double tolerance = VolumeHaptics::ForceAugmentation::Tolerance;
  for (const StiffArm& arm : { StiffArm::FalconLike(), StiffArm::TouchLike() })
  {
    for (const StiffPress& press : MakePresses(10.0, true))
    {
      SCOPED_TRACE(Describe(arm, press));
      EXPECT_LE(PressStiffly(arm, press).MostWithoutFriction, tolerance) << "the largest gain";
    }
  }
  // On this wall, damping can't make the loop stable. Without the energy account, the loop gives up
  // to 35 mJ.
  const StiffArm arm = StiffArm::FalconLike();
  double without = 0.0;
  for (StiffPress press : MakePresses(20.0, true))
  {
    SCOPED_TRACE(Describe(arm, press));
    const StiffResult result = PressStiffly(arm, press);
    EXPECT_LE(result.MostGiven, tolerance);
    // A measured bound. If the account also spent the energy that the soft spring still returns,
    // the loop would give 6 mJ.
    EXPECT_LE(result.MostWithoutFriction, 2.5 * tolerance);
    press.Augments = false;
    without = std::max(without, PressStiffly(arm, press).MostGiven);
  }
  EXPECT_GT(without, 0.01);
}

TEST(ForceAugmentation, KnowsASpringWithSlackByItsSlope)
{
  // With 3 mm of slack, force divided by depth is only a small part of the slope that the loop
  // feels.
  const StiffArm arm = StiffArm::FalconLike();
  for (StiffPress press : MakePresses(6.0, true))
  {
    SCOPED_TRACE(Describe(arm, press));
    press.Slack = 3e-3;
    const StiffResult result = PressStiffly(arm, press);
    EXPECT_GE(result.Shown, 5.0 * arm.Sampled());
    EXPECT_LE(result.Ratio, 1.0);
    EXPECT_EQ(result.MostGiven, 0.0);
    EXPECT_LE(result.MostWithoutFriction, VolumeHaptics::ForceAugmentation::Tolerance);
  }
}

TEST(ForceAugmentation, LeavesSoftWallsToTheBit)
{
  using namespace VolumeHaptics;
  SafetyLimits limits;
  limits.MaximumForce = 8.0;
  limits.RampTime = 0.0;
  GatedStage plain;
  GatedStage augmented;
  plain.Arm();
  augmented.Arm();
  SafetyInput input;
  input.Elapsed = input.Period = input.MotionTime = input.RoundTrip = 1e-3;
  input.Fresh = true;
  input.Stiffness = 900.0;
  for (int i = 0; i < 400; ++i)
  {
    input.Tip = { 1e-3 * std::sin(0.05 * i), 0.0, 2e-3 * std::cos(0.03 * i) };
    input.Stretch = std::max(0.0, -input.Tip.Z);
    input.Force.Z = input.Stiffness * input.Stretch;
    input.Feedback = 0.0;
    const Vector3 expected = plain.Apply(input, limits);
    input.Feedback = 1000.0;
    EXPECT_TRUE(IsIdentical(augmented.Apply(input, limits), expected)) << i;
  }
}
