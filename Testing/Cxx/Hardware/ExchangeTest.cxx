// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * What passes between the servo and a device's thread, and what must not.
 */

#include "../Servo/ThreadWatch.h"
#include "HardwareExchange.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include <poll.h>

using namespace VolumeHaptics;

namespace
{
std::int64_t Asleep = 0;

class HardwareExchangeTest : public testing::Test
{
protected:
  HardwareExchangeTest()
  {
    Asleep = 0;
    this->Exchange.Begin();
  }
  DeviceState Take()
  {
    this->Sample.Fresh = false;
    return this->Exchange.Take(this->Sample);
  }
  bool IsAwake()
  {
    pollfd wake{ this->Exchange.GetWakeDescriptor(), POLLIN, 0 };
    return poll(&wake, 1, 0) == 1;
  }

  HardwareExchange Exchange{ [] { return Asleep; } };
  DeviceSample Sample;
};
} // namespace

TEST_F(HardwareExchangeTest, SamplesPassOnceAndOnlyWhileTheDeviceIsReady)
{
  DeviceSample told;
  told.Tip = { 1.0, 2.0, 3.0 };
  this->Exchange.Tell(told);
  EXPECT_EQ(this->Take(), DeviceState::NotReady);
  EXPECT_FALSE(this->Sample.Fresh);
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_EQ(this->Take(), DeviceState::Running);
  EXPECT_TRUE(this->Sample.Fresh);
  EXPECT_EQ(this->Sample.Tip.Z, 3.0);
  EXPECT_EQ(this->Take(), DeviceState::Running);
  EXPECT_FALSE(this->Sample.Fresh);
}

TEST_F(HardwareExchangeTest, ForceIsZeroUnlessReadyGivenAndNotQuenched)
{
  const auto force = [this] { return this->Exchange.GetForce().X; };
  EXPECT_EQ(this->Exchange.Give({ 2.0, 0.0, 0.0 }), DeviceState::Running);
  EXPECT_EQ(force(), 0.0) << "not ready";
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  this->Exchange.Give({ 2.0, 0.0, 0.0 });
  EXPECT_GT(force(), 0.0);
  this->Exchange.Quench();
  EXPECT_FALSE(this->Exchange.IsAtRest());
  EXPECT_EQ(force(), 0.0);
  EXPECT_FALSE(this->Exchange.IsAtRest()) << "it has been asked for, but may not have been sent";
  EXPECT_EQ(force(), 0.0);
  EXPECT_TRUE(this->Exchange.IsAtRest());
  this->Exchange.Give({ NAN, 0.0, 0.0 });
  EXPECT_EQ(force(), 0.0);
}

TEST_F(HardwareExchangeTest, AForceThatNobodyRenewsFades)
{
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  this->Exchange.Give({ 2.0, 0.0, 0.0 });
  const double age = HardwareExchange::WatchdogTime + HardwareExchange::FadeTime;
  std::this_thread::sleep_for(std::chrono::duration<double>(age));
  EXPECT_EQ(this->Exchange.GetForce().X, 0.0);
}

TEST_F(HardwareExchangeTest, WhatIsLostStaysSoUntilItIsHomed)
{
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  this->Exchange.SetCondition(DeviceStage::Lost, "it was unplugged.");
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_EQ(this->Take(), DeviceState::Lost);
  EXPECT_EQ(this->Exchange.Give({ 1.0, 0.0, 0.0 }), DeviceState::Lost);
  EXPECT_EQ(this->Exchange.GetForce().X, 0.0);
  EXPECT_STREQ(this->Exchange.GetCondition().Text.data(), "it was unplugged.");
  EXPECT_FALSE(this->Exchange.TakeHomeRequest());
  this->Exchange.RequestHome();
  EXPECT_EQ(this->Take(), DeviceState::Lost) << "before the device's thread has seen it";
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Homing) << "for who asked, at once";
  EXPECT_TRUE(this->Exchange.TakeHomeRequest());
  EXPECT_EQ(this->Take(), DeviceState::NotReady);
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Homing);
  EXPECT_FALSE(this->Exchange.TakeHomeRequest());
}

TEST_F(HardwareExchangeTest, ASleepOfTheComputerIsALoss)
{
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  Asleep = 1000; // what the two clocks are apart
  EXPECT_FALSE(this->Exchange.HasSlept());
  Asleep = 3600 * std::int64_t{ 1000000000 };
  EXPECT_TRUE(this->Exchange.HasSlept());
  EXPECT_EQ(this->Take(), DeviceState::Lost);
  EXPECT_FALSE(this->Exchange.HasSlept()) << "only once";
  EXPECT_EQ(this->Take(), DeviceState::Lost);
}

TEST_F(HardwareExchangeTest, TheDeviceIsWokenByForcesStopsAndRequests)
{
  EXPECT_FALSE(this->IsAwake());
  const auto wakes = [this](auto&& action)
  {
    action();
    const bool is = this->IsAwake();
    this->Exchange.ClearWake();
    return is && !this->IsAwake();
  };
  EXPECT_TRUE(wakes([this] { this->Exchange.Give({}); }));
  EXPECT_TRUE(wakes([this] { this->Exchange.Quench(); }));
  EXPECT_TRUE(wakes([this] { this->Exchange.RequestHome(); }));
  EXPECT_TRUE(wakes([this] { this->Exchange.RequestStop(); }));
  EXPECT_TRUE(this->Exchange.MustStop());
}

TEST_F(HardwareExchangeTest, TheServoNeitherLocksNorAllocates)
{
  servotest::WatchThisThread(true);
  for (int tick = 0; tick < 1000; ++tick)
  {
    const auto stage = static_cast<DeviceStage>(tick % 4);
    this->Exchange.SetCondition(stage, "as it is");
    this->Exchange.Tell(this->Sample);
    this->Take();
    this->Exchange.Give({ 1.0, 2.0, 3.0 });
    this->Exchange.Quench();
  }
  servotest::WatchThisThread(false);
  EXPECT_EQ(servotest::GetWatched().Allocations, 0u);
  EXPECT_EQ(servotest::GetWatched().Locks, 0u);
}
