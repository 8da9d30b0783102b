// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A device that reports more slowly than the servo ticks: what it said holds until it says something else.
 */
#include "HardwareExchange.h"

#include <gtest/gtest.h>

using namespace VolumeHaptics;

TEST(ExchangeHolds, ButtonsAndTurnsBetweenReports)
{
  HardwareExchange exchange;
  exchange.Begin();
  exchange.SetCondition(DeviceStage::Ready, "");
  DeviceSample none;
  EXPECT_EQ(exchange.Take(none), DeviceState::Running);
  EXPECT_FALSE(none.Fresh) << "it has said nothing yet";
  EXPECT_EQ(none.Buttons, 0u);

  DeviceSample told;
  told.Tip = { 0.01, 0.02, 0.03 };
  told.Buttons = 5;
  told.Turn = { 0.0, 0.0, 1.0 };
  exchange.Tell(told);
  for (int tick = 0; tick < 3; ++tick)
  {
    DeviceSample sample;
    EXPECT_EQ(exchange.Take(sample), DeviceState::Running);
    EXPECT_EQ(sample.Fresh, tick == 0);
    EXPECT_EQ(sample.Begins, tick == 0);
    EXPECT_EQ(sample.Tip.Y, 0.02);
    EXPECT_EQ(sample.Buttons, 5u);
    EXPECT_EQ(sample.Turn.Z, 1.0);
  }

  told.Buttons = 0;
  exchange.Tell(told);
  DeviceSample released;
  exchange.Take(released);
  EXPECT_TRUE(released.Fresh);
  EXPECT_EQ(released.Buttons, 0u);

  // What was said before a homing holds no longer.
  exchange.RequestHome();
  EXPECT_TRUE(exchange.TakeHomeRequest());
  exchange.SetCondition(DeviceStage::Ready, "");
  DeviceSample homed;
  homed.Buttons = 7;
  EXPECT_EQ(exchange.Take(homed), DeviceState::NotReady);
  EXPECT_EQ(exchange.Take(homed), DeviceState::Running);
  EXPECT_FALSE(homed.Fresh);
  EXPECT_EQ(homed.Buttons, 7u) << "untouched";
}
