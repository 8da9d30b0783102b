// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the exchange of samples and conditions between the servo and a device's thread.
 */

#include "ExchangeRig.h"

#include <string>

using namespace hardwaretest;

using DeviceExchange = ExchangeTest;

TEST_F(DeviceExchange, SamplesPassOnceAndOnlyWhileTheDeviceIsReady)
{
  DeviceSample told;
  told.Tip = { 1.0, 2.0, 3.0 };
  this->Exchange.Report(told);
  EXPECT_EQ(this->Take(), DeviceState::NotReady);
  EXPECT_FALSE(this->Sample.Fresh);
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_EQ(this->Take(), DeviceState::Running);
  EXPECT_TRUE(this->Sample.Fresh);
  EXPECT_EQ(this->Sample.Tip.Z, 3.0);
  EXPECT_EQ(this->Take(), DeviceState::Running);
  EXPECT_FALSE(this->Sample.Fresh);
}

TEST_F(DeviceExchange, WhatIsLostStaysSoUntilItIsHomed)
{
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  this->Exchange.SetCondition(DeviceStage::Lost, "it was unplugged.");
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  EXPECT_EQ(this->Take(), DeviceState::Lost);
  EXPECT_EQ(this->Exchange.Give({ 1.0, 0.0, 0.0 }), DeviceState::Lost);
  EXPECT_EQ(this->Exchange.GetForce().X, 0.0);
  EXPECT_STREQ(this->Exchange.GetCondition().Text.data(), "it was unplugged.");
  EXPECT_FALSE(this->Exchange.DrainHomeRequest());
  this->Exchange.RequestHome();
  EXPECT_EQ(this->Take(), DeviceState::Lost) << "before the device's thread has seen it";
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Homing) << "for who asked, at once";
  EXPECT_TRUE(this->Exchange.DrainHomeRequest());
  EXPECT_EQ(this->Take(), DeviceState::NotReady);
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Homing);
  EXPECT_FALSE(this->Exchange.DrainHomeRequest());
}

TEST_F(DeviceExchange, ATextBeginsWithTheDevicesNameUnlessItIsEmpty)
{
  const auto text = [this] { return std::string(this->Exchange.GetCondition().Text.data()); };
  this->Exchange.SetCondition(DeviceStage::Homing, "Falcon 1", "waits for the hand.");
  EXPECT_EQ(text(), "Falcon 1 waits for the hand.");
  this->Exchange.SetCondition(DeviceStage::Ready, "Falcon 1", "");
  EXPECT_EQ(text(), "");
  EXPECT_EQ(this->Exchange.GetCondition().Stage, DeviceStage::Ready);
  const std::size_t room = DeviceCondition().Text.size() - 1;
  this->Exchange.SetCondition(DeviceStage::Lost, "Falcon", std::string(2 * room, 'x').c_str());
  EXPECT_EQ(text(), "Falcon " + std::string(room - 7, 'x')) << "cut to the room for it";
}

TEST_F(DeviceExchange, ASleepOfTheComputerIsALoss)
{
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  Asleep = 1000; // ns; the size of a normal difference between two clocks
  EXPECT_FALSE(this->Exchange.HasSlept());
  Asleep = 3600 * std::int64_t{ 1000000000 };
  EXPECT_TRUE(this->Exchange.HasSlept());
  EXPECT_EQ(this->Take(), DeviceState::Lost);
  EXPECT_FALSE(this->Exchange.HasSlept()) << "only once";
  EXPECT_EQ(this->Take(), DeviceState::Lost);
}
