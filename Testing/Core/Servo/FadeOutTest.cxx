// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a force which fades out reaches zero without a step, and that the force of a loop
 * whose owner is silent fades out by itself.
 */

#include "Rigs/FadingLoop.h"

using namespace servotest;

namespace
{
constexpr double Rate = 5000.0;

/// A case: the largest force (N) and its largest rate of change (N/s).
struct LimitsCase
{
  const char* Name;
  double Force;
  double ForceRate;
};

class FadeOut
  : public FadingLoop
  , public testing::WithParamInterface<LimitsCase>
{
protected:
  FadeOut()
    : FadingLoop(Rate)
  {
    this->Limits.MaximumForce = this->GetParam().Force;
    this->Limits.MaximumForceRate = this->GetParam().ForceRate;
  }
  /// Arms the loop, waits until force acts, and holds the hand still.
  void Hold(RunningLoop& loop)
  {
    const double enough = std::min(0.5, 0.9 * this->Limits.MaximumForce);
    loop->Publish(std::make_shared<HapticModel>(Describe(this->Volume)));
    loop->Arm();
    ASSERT_TRUE(Eventually([&] { return this->Device.Force.load() > enough; }));
    this->Device.Frozen.store(true);
    loop->SetRecording(true);
    this->Follow(loop, 200); // until the slew limit has let the force grow
  }
  /// Reads `ticks` snapshots. Expects a force in exactly those ticks in which force may flow, and
  /// counts the ticks of the fade.
  void Follow(RunningLoop& loop, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      ASSERT_NO_FATAL_FAILURE(this->Take(loop));
      const ServoSnapshot& s = this->Last;
      // Use the loop's own snapshots, so that the delay of this thread does not matter.
      const bool flows = s.IsArmed() && s.GetFault() == GateReason::None && s.Residency > 0.0;
      this->Falling += flows && s.Residency < 1.0;
      EXPECT_EQ(flows, Norm(s.Command) > 0.0);
    }
  }
  void ExpectFade(GateReason fault)
  {
    EXPECT_EQ(Norm(this->Last.Command), 0.0);
    EXPECT_EQ(this->Last.GetFault(), fault);
    EXPECT_EQ(this->Last.IsArmed(), fault != GateReason::None);
    EXPECT_NEAR(this->Falling, ForceGate::FadeTime * Rate, 3.0) << "over the whole time";
  }

  int Falling = 0; ///< number of ticks during the fade
};
} // namespace

TEST(FadeOutOrder, NeverUndoesADisarmOfAnotherThread)
{
  PlayedDevice device;
  for (int i = 0; i < Lives(300); ++i)
  {
    ServoLoop loop(device, Rate);
    loop.Arm();
    std::atomic<int> ready{ 0 };
    const auto order = [&](void (ServoLoop::*give)() noexcept)
    {
      ++ready;
      while (ready < 2)
      {
        std::this_thread::yield();
      }
      (loop.*give)();
    };
    std::thread other([&] { order(&ServoLoop::Disarm); });
    order(&ServoLoop::FadeOut);
    other.join();
    loop.SetRecording(true);
    std::thread servo([&] { loop.Run(); });
    ServoSnapshot first;
    EXPECT_TRUE(Eventually([&] { return loop.Drain(first); }));
    loop.RequestStop();
    servo.join();
    // If a fade had begun, the residency of this tick would be less than 1.
    ASSERT_EQ(first.Residency, 1.0) << "after " << i << " rounds";
  }
}

TEST_P(FadeOut, GetsToZeroWithoutAStep)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  this->Hold(loop);
  this->Falling = 0;
  loop->FadeOut();
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Follow(loop, 20);
      return !this->Last.IsArmed();
    }));
  this->ExpectFade(GateReason::None);
}

TEST_P(FadeOut, ComesByItselfWithoutAttentionAndHoldsUntilArmed)
{
  RunningLoop loop(this->Device, Rate, this->Limits);
  this->Hold(loop);
  this->Falling = 0;
  this->Limits.AttentionTime = 0.05;
  loop->SetLimits(this->Limits); // by now, the owner has been silent for too long since Arm()
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Follow(loop, 20);
      return this->Last.GetFault() != GateReason::None;
    }));
  loop->Attend();
  this->Follow(loop, 200);
  this->ExpectFade(GateReason::Unattended);
  this->Limits.AttentionTime = 60.0;
  loop->SetLimits(this->Limits);
  this->Device.Frozen.store(false); // the force starts again from zero at the tip
  loop->Arm();
  EXPECT_TRUE(Eventually([this] { return this->Device.Force.load() > 0.0; }));
}

INSTANTIATE_TEST_SUITE_P(Limits, FadeOut,
  testing::Values(LimitsCase{ "Clamped", 0.1, 500.0 }, LimitsCase{ "ClampedAndSlow", 0.1, 1.0 },
    LimitsCase{ "Slow", 4.0, 5.0 }, LimitsCase{ "Usual", 4.0, 500.0 }),
  [](const testing::TestParamInfo<LimitsCase>& info) { return std::string(info.param.Name); });
