// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests back ends that freeze, are lost, quenched or closed, or reach the end of a recording.
 */

#include "Devices/Replay/ReplayDevice.h"
#include "Devices/Virtual/VirtualDevice.h"

#include <gtest/gtest.h>

using namespace VolumeHaptics;

namespace
{
constexpr double Period = 1e-3;
}

TEST(VirtualDevice, GivesNothingFreshWhileFrozen)
{
  VirtualDevice device;
  device.Lead({ 0.1, 0.0, 0.0 });
  DeviceSample sample;
  device.Freeze(true);
  EXPECT_EQ(device.Read(Period, sample), DeviceState::Running);
  EXPECT_FALSE(sample.Fresh);
  device.Freeze(false);
  EXPECT_EQ(device.Read(Period, sample), DeviceState::Running);
  EXPECT_TRUE(sample.Fresh);
}

TEST(VirtualDevice, IsLostUntilItIsOpenedAgain)
{
  VirtualDevice device;
  DeviceSample sample;
  device.Unplug();
  EXPECT_EQ(device.Read(Period, sample), DeviceState::Lost);
  EXPECT_FALSE(sample.Fresh);
  EXPECT_EQ(device.Write({}), DeviceState::Lost);
  std::string error;
  EXPECT_TRUE(device.Open(error));
  EXPECT_EQ(device.Read(Period, sample), DeviceState::Running);
}

TEST(VirtualDevice, QuenchTakesTheForceAwayUntilTheNextWrite)
{
  VirtualDevice device;
  VirtualDynamics dynamics;
  dynamics.Mass = 0.1;
  device.SetDynamics(dynamics);
  device.Lead({});
  DeviceSample sample;
  device.Read(Period, sample);
  device.Write({ 2.0, 0.0, 0.0 });
  EXPECT_EQ(device.GetActingForce(0), 2.0);
  device.Quench();
  EXPECT_EQ(device.GetActingForce(0), 0.0);
  device.Read(Period, sample);
  EXPECT_EQ(sample.Tip.X, 0.0) << "nothing pushed";
  device.Write({ 2.0, 0.0, 0.0 });
  device.Read(Period, sample);
  EXPECT_GT(sample.Tip.X, 0.0);
}

TEST(VirtualDevice, CloseTakesTheForceAway)
{
  VirtualDevice device;
  device.Write({ 2.0, 1.0, -1.0 });
  device.Close();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(device.GetActingForce(axis), 0.0);
  }
}

TEST(VirtualDevice, KeepsItsPlaceWhenOpenedAgain)
{
  VirtualDevice device;
  device.Lead({ 0.1, 0.0, 0.0 });
  DeviceSample sample;
  device.Read(Period, sample);
  std::string error;
  device.Open(error);
  device.Read(Period, sample);
  EXPECT_EQ(sample.Tip.X, 0.1);
}

TEST(ReplayDevice, PlaysEveryTipOnceThenIsFinished)
{
  ReplayDevice device({ { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } }, "replay:test");
  std::string error;
  for (int round = 0; round < 2; ++round)
  {
    ASSERT_TRUE(device.Open(error)) << "each time from the beginning";
    for (int i = 0; i < 3; ++i)
    {
      DeviceSample sample;
      EXPECT_EQ(device.Read(Period, sample), DeviceState::Running);
      EXPECT_TRUE(sample.Fresh);
      EXPECT_EQ(sample.Tip.X, 1 + 3 * i);
      EXPECT_EQ(sample.Tip.Z, 3 + 3 * i);
    }
    for (int i = 0; i < 5; ++i)
    {
      DeviceSample sample;
      EXPECT_EQ(device.Read(Period, sample), DeviceState::Finished);
      EXPECT_FALSE(sample.Fresh);
      EXPECT_EQ(sample.Tip.Y, 8) << "it stays at the last tip";
    }
    EXPECT_EQ(device.Write({ 1, 1, 1 }), DeviceState::Finished);
  }
}

TEST(ReplayDevice, PlaysTheOrientationsThatItHas)
{
  const Quaternion turned{ 0.6, 0.0, 0.8, 0.0 };
  ReplayDevice device({ { 1, 2, 3 }, { 4, 5, 6 } }, "replay:test", { turned });
  std::string error;
  ASSERT_TRUE(device.Open(error));
  DeviceSample sample;
  device.Read(Period, sample);
  EXPECT_TRUE(sample.HasOrientation);
  EXPECT_TRUE(IsIdentical(sample.Orientation, turned));
  device.Read(Period, sample);
  EXPECT_FALSE(sample.HasOrientation) << "it has no second one";
}

TEST(ReplayDevice, RefusesNoTipsAndNamesItself)
{
  ReplayDevice device({}, "replay:nothing.csv");
  std::string error;
  EXPECT_FALSE(device.Open(error));
  EXPECT_NE(error.find("replay:nothing.csv"), std::string::npos) << error;
  EXPECT_EQ(device.GetName(), "replay:nothing.csv");
}
