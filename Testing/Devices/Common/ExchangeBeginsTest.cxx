// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Expects that the first sample after a device was not ready begins a new motion for the servo. */

#include "Devices/Common/HardwareExchange.h"

#include <gtest/gtest.h>

using namespace VolumeHaptics;

namespace
{
/// Returns whether the next sample begins a new motion of the hand.
bool Begins(HardwareExchange& exchange)
{
  DeviceSample told;
  told.Tip = { 0.01, 0.0, 0.0 };
  exchange.Report(told);
  DeviceSample sample;
  EXPECT_EQ(exchange.Receive(sample), DeviceState::Running);
  EXPECT_TRUE(sample.Fresh);
  EXPECT_EQ(sample.Tip.X, 0.01);
  return sample.Begins;
}
} // namespace

TEST(HardwareExchange, TheFirstSampleSinceADeviceBecameReadyBegins)
{
  HardwareExchange exchange;
  exchange.Begin();
  exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_TRUE(Begins(exchange));
  EXPECT_FALSE(Begins(exchange));
  EXPECT_FALSE(Begins(exchange));

  DeviceSample sample;
  exchange.SetCondition(DeviceStage::Homing, "");
  EXPECT_EQ(exchange.Receive(sample), DeviceState::NotReady);
  exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_TRUE(Begins(exchange)) << "homed";
  EXPECT_FALSE(Begins(exchange));

  exchange.SetCondition(DeviceStage::Lost, "");
  EXPECT_EQ(exchange.Receive(sample), DeviceState::Lost);
  exchange.RequestHome();
  EXPECT_TRUE(exchange.DrainHomeRequest());
  exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_TRUE(Begins(exchange)) << "found again";
}

TEST(HardwareExchange, AServoThatSleptThroughHomingHearsOfItAllTheSame)
{
  HardwareExchange exchange;
  exchange.Begin();
  exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_TRUE(Begins(exchange));
  exchange.RequestHome();
  EXPECT_TRUE(exchange.DrainHomeRequest());
  exchange.SetCondition(DeviceStage::Ready, "");
  DeviceSample sample;
  EXPECT_EQ(exchange.Receive(sample), DeviceState::NotReady);
  EXPECT_TRUE(Begins(exchange));
  exchange.SetCondition(DeviceStage::Ready, "still");
  EXPECT_FALSE(Begins(exchange));
}

TEST(HardwareExchange, BetweenSamplesTheLastOneHolds)
{
  HardwareExchange exchange;
  exchange.Begin();
  DeviceSample told;
  told.Tip = { 0.01, 0.0, 0.0 };
  told.Turn = { 0.0, 1.0, 0.0 };
  told.Buttons = 5;
  exchange.Report(told);
  exchange.SetCondition(DeviceStage::Ready, "");
  for (const bool isFresh : { true, false, false })
  {
    DeviceSample sample;
    EXPECT_EQ(exchange.Receive(sample), DeviceState::Running);
    EXPECT_EQ(sample.Fresh, isFresh);
    EXPECT_EQ(sample.Begins, isFresh);
    EXPECT_EQ(sample.Tip.X, 0.01);
    EXPECT_EQ(sample.Turn.Y, 1.0);
    EXPECT_EQ(sample.Buttons, 5U);
  }
}
