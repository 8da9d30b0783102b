// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the outgoing torque stays within its bound, grows at most by its limit, acts only
 * while force may flow, and gives back at most the energy that the hand has put in.
 */

#include "Core/Safety/TorqueStage.h"
#include "Rigs/GatedStage.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <limits>

using namespace coretest;

namespace
{
class Torques : public testing::Test
{
protected:
  Torques()
  {
    this->Limits.MaximumForce = 4.0;
    this->Limits.RampTime = 0.1;
    this->Limits.MaximumTorque = 0.2;
    this->Limits.MaximumTorqueRate = 5.0;
    this->Forces.Elapsed = this->Forces.Period;
    this->Forces.Fresh = true;
    this->Input.IsMeasured = true;
  }

  Vector3 Apply(const Vector3& torque)
  {
    this->Forces.Torque = torque;
    this->Gated.Apply(this->Forces, this->Limits);
    this->Input.Torque = torque;
    const Vector3 before = this->Output;
    this->Output = this->Stage.Apply(this->Input, this->Limits, this->Gated.Gate);
    EXPECT_TRUE(IsFinite(this->Output));
    EXPECT_LE(Norm(this->Output), this->Limits.MaximumTorque * (1.0 + 1e-12));
    EXPECT_LE(Norm(this->Output) - Norm(before), 5e-3 * (1.0 + 1e-9));
    return this->Output;
  }
  Vector3 Repeat(const Vector3& torque, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->Apply(torque);
    }
    return this->Output;
  }
  bool IsNone() const { return Norm(this->Output) == 0.0; }

  rigs::GatedStage Gated;
  TorqueStage Stage;
  SafetyLimits Limits;
  SafetyInput Forces;
  TorqueInput Input;
  Vector3 Output;
};
} // namespace

TEST_F(Torques, FlowOnlyWhileForceMayFlow)
{
  const Vector3 torque{ 0.05, -0.02, 0.01 };
  this->Repeat(torque, 100);
  EXPECT_TRUE(this->IsNone()) << "disarmed";
  this->Gated.Arm();
  this->Repeat(torque, 50);
  EXPECT_NEAR(Norm(this->Output), 0.5 * Norm(torque), 0.02 * Norm(torque)) << "half of the ramp";
  this->Repeat(torque, 60);
  EXPECT_TRUE(IsIdentical(this->Output, torque)) << "to the bit";
  this->Gated.Gate.Disarm();
  this->Apply(torque);
  EXPECT_TRUE(this->IsNone());
  this->Gated.Arm();
  this->Repeat(torque, 200);
  this->Gated.Gate.FadeOut();
  // The fade advances only with the opening of the data, which the servo reports in each tick.
  for (int i = 0; i < 60; ++i)
  {
    this->Gated.Gate.ReportData(1.0, 1e-3);
    this->Apply(torque);
  }
  EXPECT_TRUE(this->IsNone());
}

TEST_F(Torques, AreClampedAndFallAtOnce)
{
  this->Gated.Arm();
  const Vector3 torque{ 0.0, 3.0, 4.0 };
  this->Repeat(torque, 400);
  EXPECT_NEAR(this->Output.Y, 0.12, 1e-12);
  EXPECT_NEAR(this->Output.Z, 0.16, 1e-12);
  this->Apply({});
  EXPECT_TRUE(this->IsNone());
  this->Limits.MaximumTorque = 0.0;
  this->Repeat(torque, 100);
  EXPECT_TRUE(this->IsNone()) << "a device without torque gets none";
}

TEST_F(Torques, ThatAreNoNumbersAreAFault)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    this->Gated.Arm();
    this->Repeat({ 0.05, 0.0, 0.0 }, 200);
    EXPECT_FALSE(this->IsNone());
    this->Apply({ 0.05, bad, 0.0 });
    EXPECT_TRUE(this->IsNone());
    EXPECT_EQ(this->Gated.Gate.GetFault(), GateReason::NotFinite);
    this->Repeat({ 0.05, 0.0, 0.0 }, 10);
    EXPECT_TRUE(this->IsNone()) << "until it is armed again";
  }
}

TEST_F(Torques, EndAtOnceWithoutSamples)
{
  this->Gated.Arm();
  this->Repeat({ 0.05, 0.0, 0.0 }, 200);
  this->Forces.Fresh = this->Input.IsMeasured = false;
  int ticks = 0;
  while (!this->IsNone() && ticks < 100)
  {
    this->Apply({ 0.05, 0.0, 0.0 });
    ++ticks;
  }
  EXPECT_NEAR(ticks, 1000.0 * this->Limits.WatchdogTime, 2.0);
}

/// The hand turns into a rotational spring of k_r (N m/rad) and back, while the ramp rises or the
/// growth is limited. The hand must not get more energy than it has put in. The device holds each
/// torque until the next tick, which adds k_r dtheta^2/2 per tick even without the stage.
TEST_F(Torques, GiveNoMoreThanTheHandPutIn)
{
  constexpr double k = 0.5; // N m/rad
  this->Input.Stiffness = k;
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double mostHeldBack = 0.0;
  for (int cycle = 0; cycle < 300; ++cycle)
  {
    this->Gated.Gate.Disarm();
    this->Apply({});
    this->Gated.Arm();
    const Vector3 axis = RandomIn(engine, 1.0);
    const Vector3 unit = (1.0 / Norm(axis)) * axis;
    const double most = 0.05 + 0.8 * uniform(engine);
    const int in = 5 + static_cast<int>(100.0 * uniform(engine));
    const int wait = static_cast<int>(150.0 * uniform(engine));
    const int out = 5 + static_cast<int>(200.0 * uniform(engine));
    double given = 0.0; // J, given to the hand
    double leak = 0.0;  // J
    double before = 0.0;
    const auto turn = [&](double angle)
    {
      const double step = angle - before;
      given += Dot(this->Output, step * unit);
      leak += 0.5 * k * step * step;
      before = angle;
      this->Input.Orientation = TurnAbout(unit, angle);
      const Vector3 wanted = (-k * angle) * unit;
      const Vector3 sent = this->Apply(wanted);
      mostHeldBack = std::max(mostHeldBack, Norm(wanted) - Norm(sent));
    };
    for (int i = 1; i <= in; ++i)
    {
      turn(most * i / in);
    }
    for (int i = 0; i < wait; ++i)
    {
      turn(most);
    }
    for (int i = 1; i <= out; ++i)
    {
      turn(most * (out - i) / out);
    }
    EXPECT_LE(given - leak, 1e-9);
    EXPECT_TRUE(this->IsNone());
  }
  EXPECT_GT(mostHeldBack, 0.1);
}
