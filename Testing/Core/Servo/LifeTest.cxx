// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the loop starts and stops, and measures its time.
 */

#include "Rigs/PlayedDevice.h"

using namespace servotest;

TEST(ServoLife, StartsAndStopsManyTimes)
{
  TestVolume volume = MakeRamp();
  const auto model = std::make_shared<const HapticModel>(Describe(volume));
  PlayedDevice device;
  for (int i = 0; i < Lives(200); ++i)
  {
    RunningLoop loop(device, 10000.0);
    loop->Publish(model);
    loop->Arm();
    if (i % 4 == 0)
    {
      ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > 2; }));
    }
  }
  EXPECT_EQ(device.Force.load(), 0.0);
  EXPECT_EQ(model.use_count(), 1);
}

TEST(ServoLife, StopsBeforeItsFirstTick)
{
  PlayedDevice device;
  ServoLoop loop(device, 1000.0);
  loop.RequestStop();
  loop.Run();
  EXPECT_EQ(device.Reads.load(), 0U);
  EXPECT_EQ(device.Writes.load(), 1U) << "zero force, all the same";
}

TEST(ServoLife, CountsAndForgetsItsTime)
{
  PlayedDevice device;
  RunningLoop loop(device, 1000.0);
  EXPECT_TRUE(Eventually([&] { return loop->GetTickRate() > 0.0; }));
  EXPECT_GT(loop->GetTickCost().GetPercentile(0.5), 0.0);
  EXPECT_GE(loop->GetWakeLatency().GetPercentile(0.99), loop->GetWakeLatency().GetPercentile(0.5));
  const std::uint64_t before = loop->GetTickCost().GetTotal();
  EXPECT_GT(before, 10U);
  loop->ResetStatistics();
  EXPECT_TRUE(Eventually([&] { return loop->GetTickCost().GetTotal() < before; }));
  EXPECT_NE(loop->GetRealTimePriority(), RealTimeGrant::Unknown);
  EXPECT_NE(loop->GetLockedMemory(), ServoLoop::Privilege::Unknown);
}

TEST(ServoLife, CountsTicksThatItMissed)
{
  struct SlowDevice : PlayedDevice
  {
    void InTick() noexcept override
    {
      if (this->Reads.load() == 10)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
      }
    }
  } device;
  RunningLoop loop(device, 1000.0);
  EXPECT_TRUE(Eventually([&] { return loop->GetTickCount() > 20; }));
  EXPECT_GE(loop->GetMissedTicks(), 24U);
}

TEST(ServoLife, TheLatestOfArmAndDisarmCounts)
{
  PlayedDevice device;
  RunningLoop loop(device);
  for (int i = 0; i < 300; ++i)
  {
    loop->Arm();
    loop->Disarm();
    if (i % 2 == 0)
    {
      loop->Arm();
    }
    const std::uint64_t from = loop->GetTickCount() + 1;
    ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > from; }));
    loop->ReadState();
    EXPECT_EQ(loop->GetState().IsArmed(), i % 2 == 0);
  }
}
