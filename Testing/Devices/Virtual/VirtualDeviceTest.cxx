// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that the device without hardware obeys its settings, tick by tick. */

#include "Devices/Virtual/VirtualDevice.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace VolumeHaptics;

namespace
{
constexpr double Period = 1e-3;

class Virtual : public testing::Test
{
protected:
  Virtual()
  {
    std::string error;
    EXPECT_TRUE(this->Device.Open(error)) << error;
  }
  DeviceSample Read()
  {
    DeviceSample sample;
    this->State = this->Device.Read(Period, sample);
    return sample;
  }
  /// Sets the dynamics, and starts from the origin.
  void Begin(const VirtualDynamics& dynamics)
  {
    this->Device.SetDynamics(dynamics);
    this->Device.Lead({});
    this->Read();
  }

  VirtualDevice Device;
  DeviceState State = DeviceState::Lost;
};
} // namespace

TEST_F(Virtual, TheFirstLeadPutsTheTipThere)
{
  this->Device.Lead({ 0.1, 0.2, 0.3 });
  const DeviceSample sample = this->Read();
  EXPECT_EQ(this->State, DeviceState::Running);
  EXPECT_TRUE(sample.Fresh);
  EXPECT_EQ(sample.Tip.X, 0.1);
  EXPECT_EQ(sample.Tip.Y, 0.2);
  EXPECT_EQ(sample.Tip.Z, 0.3);
}

TEST_F(Virtual, PlacingTakesTheStylusUpAnewAndSaysSoOnce)
{
  this->Device.Lead({ 0.1, 0.2, 0.3 });
  EXPECT_TRUE(this->Read().Begins);
  this->Device.Lead({ 0.1, 0.2, 0.4 });
  EXPECT_FALSE(this->Read().Begins);
  this->Device.Place({ 0.0, 0.0, 0.1 });
  // Move the target farther before the next read.
  this->Device.Lead({ 0.0, 0.0, 0.1001 });
  const DeviceSample sample = this->Read();
  EXPECT_TRUE(sample.Begins);
  EXPECT_EQ(sample.Tip.Z, 0.1001);
  EXPECT_FALSE(this->Read().Begins);
}

TEST_F(Virtual, ThenItGoesStraightAtTheHandsSpeedAndArrivesToTheBit)
{
  this->Begin({});
  const Vector3 target{ 0.03, 0.0, 0.04 };
  this->Device.Lead(target);
  for (int i = 1; i <= 24; ++i)
  {
    const DeviceSample sample = this->Read();
    EXPECT_NEAR(sample.Tip.X, 0.0012 * i, 1e-12);
    EXPECT_NEAR(sample.Tip.Z, 0.0016 * i, 1e-12);
  }
  this->Read();
  const DeviceSample sample = this->Read();
  EXPECT_EQ(sample.Tip.X, target.X);
  EXPECT_EQ(sample.Tip.Z, target.Z);
}

TEST_F(Virtual, ReportsButtonsAndRoundsToTheEncodersQuantum)
{
  VirtualDynamics dynamics;
  dynamics.EncoderQuantum = 1e-4;
  this->Begin(dynamics);
  this->Device.SetButtons(5);
  this->Device.Lead({ 0.00124, -0.00016, 0.00004 });
  const DeviceSample sample = this->Read();
  EXPECT_EQ(sample.Buttons, 5U);
  EXPECT_NEAR(sample.Tip.X, 0.0012, 1e-15);
  EXPECT_NEAR(sample.Tip.Y, -0.0002, 1e-15);
  EXPECT_EQ(sample.Tip.Z, 0.0);
}

TEST_F(Virtual, DelaysForcesByTicks)
{
  for (const int delay : { 0, 1, 3, VirtualDynamics::MaximumDelay })
  {
    VirtualDynamics dynamics;
    dynamics.ForceDelay = delay;
    this->Device.SetDynamics(dynamics);
    std::string error;
    this->Device.Open(error);
    for (int i = 1; i <= 40; ++i)
    {
      this->Device.Write({ 1.0 * i, -2.0 * i, 0.0 });
      EXPECT_EQ(this->Device.GetActingForce(0), std::max(0, i - delay)) << delay;
      EXPECT_EQ(this->Device.GetActingForce(1), -2.0 * std::max(0, i - delay)) << delay;
    }
  }
}

TEST_F(Virtual, TheStylusTurnsWhenItIsToldTo)
{
  this->Device.Lead({ 0.1, 0.2, 0.3 });
  EXPECT_FALSE(this->Read().HasOrientation);
  this->Device.Turn({ 0.6, 0.0, 0.0, -0.8 });
  const DeviceSample turned = this->Read();
  EXPECT_TRUE(turned.HasOrientation);
  EXPECT_EQ(turned.Orientation.W, 0.6);
  EXPECT_EQ(turned.Orientation.Z, -0.8);
  EXPECT_EQ(turned.Tip.Y, 0.2) << "where it was";
  EXPECT_FALSE(turned.Begins);
  this->Device.Place({ 0.0, 0.0, 0.0 });
  EXPECT_EQ(this->Read().Orientation.W, 0.6) << "as it was, at another position";
  this->Device.ForgetTurn();
  EXPECT_FALSE(this->Read().HasOrientation);
}

TEST_F(Virtual, ATurnIsNoPosition)
{
  this->Device.Turn({ 0.6, 0.0, 0.0, -0.8 });
  EXPECT_FALSE(this->Read().Fresh) << "the tip was led nowhere yet";
}
