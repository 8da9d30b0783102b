// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a held loop sends no force, whatever other orders it gets. After the release, the
 * loop must continue as after Arm().
 */

#include "Rigs/FadingLoop.h"

using namespace servotest;

namespace
{
constexpr double Rate = 2000.0;

class Hold : public FadingLoop
{
protected:
  Hold()
    : FadingLoop(Rate)
  {
    this->Limits.RampTime = 0.05;
  }
  /// Arms the loop while the hand moves up and down in a ramp of V = 100 z. Waits until force
  /// flows.
  void Press(RunningLoop& loop)
  {
    loop->Publish(std::make_shared<HapticModel>(Describe(this->Volume)));
    loop->Arm();
    ASSERT_TRUE(this->WaitForce());
    loop->SetRecording(true);
    this->HasLast = false;
    ASSERT_NO_FATAL_FAILURE(this->Follow(loop, 51));
  }
  bool WaitForce()
  {
    return Eventually([&] { return this->Device.Force.load() > 0.5; });
  }
  static bool WaitRest(RunningLoop& loop)
  {
    return Eventually([&] { return loop->IsAtRest(); });
  }
  void Follow(RunningLoop& loop, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      ASSERT_NO_FATAL_FAILURE(this->Take(loop));
    }
  }
  void DrainAll(RunningLoop& loop)
  {
    while (loop->Drain(this->Last))
    {
    }
  }
  /// Expects no force in the next 200 ticks.
  void ExpectNone(RunningLoop& loop)
  {
    this->DrainAll(loop);
    for (int i = 0; i < 200; ++i)
    {
      ServoSnapshot s;
      ASSERT_TRUE(Eventually([&] { return loop->Drain(s); }));
      EXPECT_EQ(Norm(s.Command), 0.0);
      this->Last = s;
    }
  }
};
} // namespace

TEST_F(Hold, FadesAndComesBackFromTheTipWithARamp)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  ASSERT_NO_FATAL_FAILURE(this->Press(loop));
  loop->Hold();
  ASSERT_TRUE(this->WaitRest(loop));
  ASSERT_NO_FATAL_FAILURE(this->Follow(loop, static_cast<int>(2.0 * ForceGate::FadeTime * Rate)));
  ASSERT_NO_FATAL_FAILURE(this->ExpectNone(loop));
  EXPECT_TRUE(this->Last.IsArmed());
  loop->Release();
  // In the first tick after the hold, the proxy starts at the tip.
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Follow(loop, 1);
      return this->HasFatalFailure() || this->Last.Residency > 0.0;
    }));
  EXPECT_FALSE(this->Last.Before.Enabled);
  EXPECT_EQ(Norm(this->Last.Record.Force), 0.0);
  double largest = 0.0;
  for (int tick = 1; tick < 1000; ++tick)
  {
    ASSERT_NO_FATAL_FAILURE(this->Follow(loop, 1));
    const double share = std::min(1.0, tick / (this->Limits.RampTime * Rate));
    largest = std::max(largest, Norm(this->Last.Command));
    EXPECT_LE(Norm(this->Last.Command), share * this->Limits.MaximumForce * (1.0 + 1e-9));
  }
  EXPECT_GT(largest, 0.1) << "force is back";
}

TEST_F(Hold, GoesOnToItsEndIfItIsReleasedMeanwhile)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  ASSERT_NO_FATAL_FAILURE(this->Press(loop));
  loop->Hold();
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Follow(loop, 1);
      return this->HasFatalFailure() || this->Last.Residency < 1.0;
    }));
  loop->Release();
  bool hasRested = false;
  for (int tick = 0; tick < 600; ++tick)
  {
    ASSERT_NO_FATAL_FAILURE(this->Follow(loop, 1));
    hasRested = hasRested || this->Last.Residency == 0.0;
  }
  EXPECT_TRUE(hasRested);
  EXPECT_EQ(this->Last.Residency, 1.0);
  EXPECT_TRUE(this->WaitForce());
}

TEST_F(Hold, NeedsNoAttention)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  ASSERT_NO_FATAL_FAILURE(this->Press(loop));
  loop->Hold();
  ASSERT_TRUE(this->WaitRest(loop));
  this->Limits.AttentionTime = 0.01;
  loop->SetLimits(this->Limits);
  ASSERT_NO_FATAL_FAILURE(this->ExpectNone(loop)); // during 0.1 s
  EXPECT_EQ(this->Last.GetFault(), GateReason::None);
  EXPECT_TRUE(this->Last.IsArmed());
  this->Limits.AttentionTime = 60.0;
  loop->SetLimits(this->Limits);
  loop->Release();
  EXPECT_TRUE(this->WaitForce());
}

TEST_F(Hold, DoesNotUndoWhatEndsTheForceMeanwhile)
{
  for (const bool fades : { false, true })
  {
    RunningLoop loop(this->Device, Rate, this->Limits);
    ASSERT_NO_FATAL_FAILURE(this->Press(loop));
    loop->Hold();
    ASSERT_TRUE(this->WaitRest(loop));
    fades ? loop->FadeOut() : loop->Disarm();
    loop->Release();
    ASSERT_NO_FATAL_FAILURE(this->ExpectNone(loop));
    EXPECT_FALSE(this->Last.IsArmed());
  }
}

TEST_F(Hold, KeepsAFault)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  ASSERT_NO_FATAL_FAILURE(this->Press(loop));
  loop->Hold();
  ASSERT_TRUE(this->WaitRest(loop));
  this->Device.ReadLost.store(true);
  ASSERT_NO_FATAL_FAILURE(this->ExpectNone(loop));
  this->Device.ReadLost.store(false);
  loop->Release();
  ASSERT_NO_FATAL_FAILURE(this->ExpectNone(loop));
  EXPECT_EQ(this->Last.GetFault(), GateReason::DeviceLost);
}

TEST_F(Hold, LetsNothingThroughThatIsArmedMeanwhile)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  ASSERT_NO_FATAL_FAILURE(this->Press(loop));
  loop->Disarm();
  loop->Hold();
  ASSERT_TRUE(this->WaitRest(loop));
  loop->Arm();
  ASSERT_NO_FATAL_FAILURE(this->ExpectNone(loop));
  EXPECT_TRUE(this->Last.IsArmed());
  loop->Release();
  EXPECT_TRUE(this->WaitForce());
}
