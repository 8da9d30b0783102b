// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the safety stage with StiffnessGain and TransientGain. With both, the force must grow at
 * most by the slew limit, fade with the gate, and add no energy.
 */

#include "SafetyRig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>

using namespace servotest;

namespace
{
constexpr double Soft = 1000.0; // stiffness (N/m) up to which the loop is stable without the gain

class Gains : public SafetyTest
{
protected:
  Gains()
  {
    this->Limits.RampTime = 0.0;
    this->Input.RoundTrip = this->Input.Period;
    this->SetWall(2000.0, false);
    this->Stage.Arm();
  }
  void SetWall(double stiffness, bool augments)
  {
    this->Wall = stiffness;
    this->Input.Stiffness = stiffness;
    this->Input.Feedback = augments ? Soft : 0.0;
  }
  /// Runs a tick with the tip at a height (m) above the wall.
  double Touch(double height)
  {
    this->Stage.Gate.ReportData(1.0, this->Input.Period);
    this->Input.Tip.Z = height;
    this->Input.Stretch = std::max(0.0, -height);
    this->Input.Frequency = height < 0.0 ? this->Pitch : 0.0;
    return this->Apply({ 0.0, 0.0, this->Wall * this->Input.Stretch }).Z;
  }
  /// Moves the tip to a height (m) at a speed (m/s). The rig checks the force of each tick.
  double Move(double height, double speed)
  {
    const double step = speed * this->Input.Period;
    while (std::abs(height - this->Input.Tip.Z) > 1e-9)
    {
      this->Touch(this->Input.Tip.Z + std::clamp(height - this->Input.Tip.Z, -step, step));
    }
    return this->Output.Z;
  }
  double Rest(int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->Touch(this->Input.Tip.Z);
    }
    return this->Output.Z;
  }
  /// Presses against a wall of ten times the stiffness Soft. Then makes a debt so large that only
  /// the soft part of the wall is felt.
  void PressInDebt()
  {
    this->SetWall(10.0 * Soft, true);
    this->Move(1e-3, 0.1);
    this->Move(-4e-4, 0.02);
    ASSERT_GT(this->Rest(20), 3.9);
    this->Input.WallWork = -5e-3;
    this->Rest(1);
    this->Input.WallWork = 0.0;
    ASSERT_NEAR(this->Rest(5), 0.4, 1e-9) << "k d";
  }

  double Wall = 0.0;    // stiffness of the wall (N/m)
  double Pitch = 120.0; // frequency of its pulses (Hz)
};
} // namespace

TEST_F(Gains, ARetreatBeginsAtWhatWasSent)
{
  this->PressInDebt();
  this->Input.Fresh = false;
  this->Rest(60);
  EXPECT_TRUE(IsZero(this->Output));
}

TEST_F(Gains, AnAccountThatIsPaidAgainRaisesTheForceByTheSlewLimit)
{
  this->PressInDebt();
  this->Input.WallWork = 0.1; // work (J) of the whole force, of which only a tenth is felt
  this->Rest(1);
  this->Input.WallWork = 0.0;
  EXPECT_GT(this->Rest(30), 3.9);
}

TEST_F(Gains, SwitchingThemWhileItPressesRaisesTheForceByTheSlewLimit)
{
  this->PressInDebt();
  this->Input.Feedback = 0.0;
  EXPECT_NEAR(this->Rest(20), 4.0, 1e-12) << "the plain wall";
  this->Input.Feedback = Soft;
  this->Rest(20);
  this->Limits.TransientGain = 1.0;
  this->Rest(20);
  this->Move(0.01, 0.3);
  this->Rest(30);
  this->Move(-1e-3, 0.3);
  this->Limits.TransientGain = 0.0;
  this->Input.Feedback = 0.0;
  this->Rest(20);
}

TEST_F(Gains, APulseThatPullsTheForceDownLeavesItToTheSlewLimit)
{
  this->Limits.TransientGain = 1.0;
  for (const bool moves : { false, true })
  {
    this->Limits.MovesTip = moves;
    for (const double speed : { 0.1, 0.3 })
    {
      this->Move(0.01, 0.3);
      this->Rest(30);
      this->Move(-3e-3, speed);
      this->Rest(100);
    }
  }
}

TEST_F(Gains, AForceThatTurnsRoundGrowsFromZero)
{
  this->Limits.MaximumForce = 8.0;
  this->Input.Stiffness = 5.0 * Soft;
  this->Input.Feedback = Soft;
  this->Input.Stretch = 1e-3;
  this->Input.WallWork = 5e-3; // work (J) that keeps the account full
  for (int i = 0; i < 30; ++i)
  {
    this->Input.Tip.Z += 5e-5;
    this->Apply({ 0.0, 0.0, 5.0 });
  }
  EXPECT_GT(this->Output.Z, 3.0);
  for (int i = 0; i < 5; ++i)
  {
    this->Input.Tip.Z += 5e-5; // moves the tip against the new force
    this->Apply({ 0.0, 0.0, -5.0 });
  }
}

TEST_F(Gains, DampingAndPulseFadeWithTheGate)
{
  this->Limits.MaximumForceRate = 1e5;
  this->Limits.MaximumForce = 100.0;
  this->Pitch = 50.0;
  for (const bool augments : { false, true })
  {
    this->SetWall(5.0 * Soft, augments);
    this->Limits.TransientGain = augments ? 0.0 : 1.0;
    this->Stage.Arm();
    this->Move(0.02, 0.3);
    this->Rest(600); // waits until all debts have ended
    this->Move(-1e-3, 0.3);
    double most = 0.0;
    this->Stage.Gate.FadeOut();
    for (int i = 0; i < 60; ++i)
    {
      this->Touch(this->Input.Tip.Z - 3e-4);
      const double beyond = this->Output.Z - this->Stage.Gate.GetShare() * this->Input.Force.Z;
      most = i == 0 ? beyond : most;
      EXPECT_LE(beyond, this->Stage.Gate.GetShare() * 12.0) << i << " " << augments;
    }
    EXPECT_GT(most, 1.0) << "N, at the beginning";
  }
}

TEST_F(Gains, APulsePaysNoDebtOfTheWall)
{
  this->Limits.MaximumForce = 30.0;
  this->Limits.MaximumForceRate = 1e4;
  for (const double gain : { 0.0, 1.0 })
  {
    this->Stage.Arm();
    this->Limits.TransientGain = gain;
    this->SetWall(10.0 * Soft, true);
    this->Move(4e-3, 0.1);
    this->Rest(600);
    this->Move(-4e-4, 0.02);
    this->Input.WallWork = -4e-3;
    this->Rest(1);
    this->Input.WallWork = 0.0;
    this->Move(4e-3, 0.2);
    this->Rest(30);
    this->Move(-2e-3, 0.2);
    EXPECT_NEAR(this->Rest(100), 2.0, 1e-9) << "k d, with a gain of " << gain;
  }
}

TEST_F(Gains, WhatWasOffHasSeenNothing)
{
  // The gain is on above the wall, off on the way into it, and on again inside it.
  for (const bool augments : { false, true })
  {
    const auto use = [&](bool isOn)
    {
      this->SetWall(augments ? 5.0 * Soft : 2.0 * Soft, augments && isOn);
      this->Limits.TransientGain = !augments && isOn ? 0.5 : 0.0;
    };
    this->Move(3e-3, 0.1);
    use(true);
    this->Rest(30);
    use(false);
    const double wall = this->Move(-5e-4, 0.05);
    EXPECT_GT(this->Rest(100), 0.9);
    use(true);
    for (int i = 0; i < 60; ++i)
    {
      EXPECT_LE(this->Rest(1), wall + 1e-9) << "a kick, " << i;
      EXPECT_GE(this->Output.Z, augments ? 0.5 - 1e-9 : wall - 1e-9);
    }
  }
}

TEST_F(Gains, ATipThatIsKnownToRestHasNoSpeed)
{
  this->SetWall(2.0 * Soft, true);
  this->Move(5e-3, 0.1);
  this->Move(-1e-3, 0.1);
  EXPECT_GT(this->Output.Z, 2.5) << "damped";
  this->Input.Fresh = false;
  this->Input.Alive = true;
  EXPECT_LT(this->Rest(20), 2.05);
}

TEST_F(Gains, TheLargestDampingShrinksWithTheRoundTrip)
{
  this->SetWall(2.0 * Soft, true);
  this->Input.RoundTrip = 3e-3;
  this->Limits.MaximumDamping = 3.0;
  this->Move(5e-3, 0.1);
  EXPECT_NEAR(this->Move(-1e-3, 0.1), 2.0 + 1.0 * 0.1, 0.01) << "3 N s/m at 1 ms are 1 at 3 ms";
}

TEST_F(Gains, NoPulseBeforeTheRoundTripIsKnown)
{
  this->Limits.MovesTip = true;
  this->Limits.TransientGain = 1.0;
  this->Input.RoundTrip = 0.0;
  this->Move(0.01, 0.3);
  this->Rest(30);
  while (this->Input.Tip.Z > -1e-3)
  {
    const double force = this->Touch(this->Input.Tip.Z - 2e-4);
    EXPECT_LE(force, this->Wall * this->Input.Stretch + 1e-12);
  }
}

TEST(GainsAccount, APulseReckonsWithThePushOfTheWall)
{
  // A stylus of 50 g rests in a wall that pushes with 5 N. In the next tick, the work of the pulse
  // must not exceed the account.
  constexpr double period = 1e-3;
  ContactTransient transient;
  TransientInput input;
  input.Gain = 1.0;
  input.Most = 100.0;
  input.Period = period;
  Vector3 tip{ 0.0, 0.0, 6e-3 };
  int pushes = 0;
  for (int i = 0; i < 60; ++i)
  {
    tip.Z -= i <= 31 ? 2e-4 : 0.0;
    transient.Observe(tip, period, 0.0, period);
    input.Frequency = i >= 30 ? 50.0 : 0.0;
    input.Wall.Z = i >= 30 ? 5.0 : 0.0;
    const double pulse = transient.Apply(input).Z - input.Wall.Z;
    if (i >= 35 && pulse > 0.0)
    {
      ++pushes;
      const double way = 0.5 * period * period / ContactTransient::LightMass * (5.0 + pulse);
      EXPECT_LE(pulse * way, transient.GetAccount() * (1.0 + 1e-9)) << i;
    }
    transient.RecordSent({ 0.0, 0.0, pulse });
  }
  EXPECT_GT(pushes, 3);
}

namespace
{
struct Path
{
  int Every = 1; ///< number of ticks between measurements
  int Delay = 0; ///< number of ticks until a force acts
};

/**
 * Moves a tip through a wall with a stiffness (N/m). Returns the largest energy (J) that the tip
 * has got back in excess of what it had put in. With `isPulse`, only the pulses count; otherwise
 * all forces do, and the work of the damping, b v^2, counts as the tip's.
 */
double FindMostGiven(const Path& path, double stiffness, bool augments, double gain, bool isPulse)
{
  constexpr double period = 1e-3;
  double most = 0.0;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    std::mt19937 engine(seed);
    const auto pick = [&engine](double a, double b) { return a + (b - a) * (engine() * 0x1p-32); };
    const double depth = pick(2e-4, 4e-3);
    const double beat = 6.283185307179586 * pick(1.0, 8.0);
    const double frequency = pick(50.0, 300.0);
    const double roundTrip = period * (path.Every + 2 * path.Delay);
    SafetyLimits limits;
    limits.MaximumForce = 20.0;
    limits.MaximumForceRate = 1e5;
    limits.MovesTip = true;
    limits.RampTime = 0.0;
    rigs::GatedStage stages[2];
    stages[0].Arm();
    stages[1].Arm();
    SafetyInput input;
    input.Elapsed = input.Period = period;
    input.MotionTime = path.Every * period;
    input.RoundTrip = roundTrip;
    input.Stiffness = stiffness;
    std::deque<double> forces(static_cast<std::size_t>(path.Delay) + 1, 0.0);
    double given = 0.0;
    double before = 0.0;
    // Without the gain, the loop is stable up to a stiffness of 2 b / T, where b is the damping and
    // T the round trip. Here, b makes this stiffness equal to Soft.
    const double b = 0.5 * Soft * roundTrip;
    for (int i = 0; i < 1000; ++i)
    {
      const double tip = depth * (std::cos(beat * period * i) + 0.2);
      if (i > 0)
      {
        const double way = tip - before;
        given += forces.front() * way - (isPulse ? 0.0 : b * way * way / period);
        most = std::max(most, given);
      }
      before = tip;
      input.Fresh = i % path.Every == 0;
      if (input.Fresh)
      {
        input.Tip.Z = tip;
        input.Stretch = std::max(0.0, -tip);
        input.Force.Z = stiffness * input.Stretch;
        input.Frequency = input.Force.Z > 0.0 ? frequency : 0.0;
      }
      input.Feedback = augments ? Soft : 0.0;
      limits.TransientGain = gain;
      double force = stages[1].Apply(input, limits).Z;
      limits.TransientGain = 0.0;
      force -= isPulse ? stages[0].Apply(input, limits).Z : 0.0;
      forces.push_back(force);
      forces.pop_front();
    }
  }
  return most;
}
} // namespace

TEST(GainsAccount, APulseCountsForAsManyTicksAsItMayBeLate)
{
  // The device measures every 4 ticks of 1 ms, and forces act 4 ms late, so any of the last 8
  // forces may have acted.
  ContactTransient transient;
  transient.Observe({}, 4e-3, 4e-3, 1e-3);
  for (int i = 0; i < 4; ++i)
  {
    transient.RecordSent({ 0.0, 0.0, i == 1 ? -2.0 : 1.0 });
  }
  transient.Observe({}, 4e-3, 4e-3, 1e-3);
  for (int i = 0; i < 4; ++i)
  {
    transient.RecordSent({ 0.0, 0.0, 1.0 });
  }
  const double before = transient.GetAccount();
  transient.Observe({ 0.0, 0.0, -1e-4 }, 4e-3, 4e-3, 1e-3);
  EXPECT_NEAR(transient.GetAccount() - before, -2.0 * 1e-4, 1e-15) << "J, the worst of them";
}

TEST(GainsAccount, PulsesGiveNothingWhateverTheDelay)
{
  for (const Path& path : { Path{ 1, 0 }, Path{ 1, 1 }, Path{ 4, 0 }, Path{ 4, 4 } })
  {
    EXPECT_LE(FindMostGiven(path, 2000.0, false, 1.0, true), 1e-6)
      << "J, " << path.Every << " " << path.Delay;
  }
}

TEST(GainsAccount, BothGainsTogetherStayWithinTheTolerance)
{
  for (const Path& path : { Path{ 1, 0 }, Path{ 1, 1 }, Path{ 4, 4 } })
  {
    EXPECT_LE(FindMostGiven(path, 6.0 * Soft, true, 1.0, false), ForceAugmentation::Tolerance)
      << "J, " << path.Every << " " << path.Delay;
  }
}
