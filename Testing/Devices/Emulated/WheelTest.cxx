// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests sessions with a wheel that does not use HID-PID, through its Linux driver: the wheel
 * presses against a wall, and each fault ends in zero force and a text.
 */

#include "DeviceBench.h"
#include "Devices/Wheel/WheelDriver.h"
#include "Emulators/EmulatedEvdev.h"
#include "Emulators/ModelClock.h"

#include <gtest/gtest.h>

#include <unistd.h>

using namespace emulated;

namespace
{
constexpr double Wall = 0.01; ///< m: position of the wall, to the right of the centre
/// Rotation from the device's axes to the wall's: the wall faces the device's left.
const Matrix3 ToTheLeft = Matrix3::FromColumns({ 0, 0, -1 }, { 0, 1, 0 }, { 1, 0, 0 });

class Wheel : public testing::Test
{
protected:
  Wheel() { this->Options.NewtonsPerFullScale = { PadModel::FullScale, 0.0 }; }

  void Open()
  {
    ASSERT_TRUE(this->Bench.Open("wheel", this->Options)) << this->Bench.Error;
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  }
  void Feel()
  {
    this->Bench.Start(this->Ground.Model);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    // Arm outside the wall. A force that begins inside would hold the hand there.
    this->Model.SetGoal(0.0);
    ASSERT_TRUE(Eventually([&] { return this->Model.GetPlace() < 0.001; }));
    this->Bench->Arm();
    const double force = -FloorStiffness * BalancedDepth(0.01);
    EXPECT_TRUE(this->Bench.Press(
      [&]
      {
        this->Model.SetGoal(Wall - 0.005);
        Eventually([&] { return this->Model.GetPlace() < Wall - 0.004; });
      },
      [&] { this->Model.SetGoal(Wall + 0.01); },
      // The wheel's force has a resolution of 0.03 N (one byte).
      [&] { return std::abs(this->Model.GetForce() - force) < 0.1; }))
      << this->Model.GetForce();
  }

  PadModel Model{ PadModel::Kind::Wheel };
  std::optional<EmulatedEvdev> Evdev{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  Floor Ground{ -Wall, ToTheLeft };
  DeviceOptions Options;
  DeviceBench Bench;
};
} // namespace

TEST_F(Wheel, IsListedAndHasItsLimits)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U) << "it is no gamepad";
  EXPECT_EQ(all[0].Id, "wheel:0");
  EXPECT_EQ(all[0].Name, this->Model.GetName() + " (" + this->Evdev->GetNode() + ")");
  EXPECT_EQ(all[0].State, "available");
  EXPECT_EQ(all[0].Identity, "") << "without a serial number it may be another one";
  ASSERT_NO_FATAL_FAILURE(this->Open());
  const DeviceLimits limits = this->Bench.Device->GetLimits();
  EXPECT_EQ(limits.MaximumForce, PadModel::FullScale);
  EXPECT_EQ(limits.ForceAxes, 1U);
  EXPECT_FALSE(limits.Vibrates);
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "wheel:046d:c24f") << "its sign is checked";
  EXPECT_FALSE(this->Bench.Device->KeepsIdentity());
  EXPECT_EQ(this->Model.GetAutocentre(), 0);
  EXPECT_TRUE(Has(ErrorOf("wheel", this->Options), "in use: another program"));
  EXPECT_TRUE(Has(ErrorOf("wheel:1", this->Options), "Count from 0"));
  this->Bench.Device->Close();
  this->Model.Refuses = true;
  EXPECT_TRUE(Has(ErrorOf("wheel", this->Options), "does not accept a constant force"));
  this->Options.NewtonsPerFullScale[0] = 0.0;
  EXPECT_TRUE(Has(ErrorOf("wheel", this->Options), "not 0"));
}

TEST_F(Wheel, LeadsTheTipAndPressesAWall)
{
  ASSERT_NO_FATAL_FAILURE(this->Open());
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_NEAR(this->Bench.State().Record.Tip.X, this->Model.GetPlace(), 1e-3);
  EXPECT_EQ(this->Bench.State().Record.Tip.Y, 0.0) << "pedals lead nothing";
  this->Model.Press(BTN_THUMB, true);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Buttons == 2U; }));
  // A wheel at rest sends no events. This must not count as a loss.
  EXPECT_TRUE(this->Bench.WaitForTicks(500));
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::None));
  EXPECT_LT(this->Model.GetForce(), -1.0);
  EXPECT_EQ(this->Model.GetLongestReplay(), WheelDriver::ReplayLength)
    << "an effect without an end would go on for ever";
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(Eventually([&] { return this->Model.GetForce() == 0.0; }));
  EXPECT_EQ(this->Model.CountEffects(), 0);
}

TEST_F(Wheel, ANegativeScaleReversesIt)
{
  this->Options.NewtonsPerFullScale[0] = -PadModel::FullScale;
  ASSERT_NO_FATAL_FAILURE(this->Open());
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "wheel:046d:c24f-x");
  EXPECT_TRUE(Eventually(
    [&]
    {
      DeviceSample sample;
      this->Bench.Device->Read(1e-3, sample);
      this->Bench.Device->Write({ 1.0, 0.0, 0.0 });
      return std::abs(this->Model.GetForce() + 1.0) < 0.05;
    }));
}

TEST_F(Wheel, AnEffectThatTheKernelHasErasedIsMadeAgain)
{
  ASSERT_NO_FATAL_FAILURE(this->Open());
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  // Before Linux 5.7, the kernel erases the effects when a child process closes its copy of the
  // node.
  this->Model.CloseFiles();
  EXPECT_TRUE(Eventually([&] { return this->Model.CountEffects() == 1; }));
  EXPECT_TRUE(Eventually([&] { return this->Model.GetForce() < -1.0; }));
  EXPECT_EQ(this->Bench.State().GetFault(), GateReason::None);
}

TEST_F(Wheel, WhatItDoesNotTakeIsALossWithAText)
{
  ASSERT_NO_FATAL_FAILURE(this->Open());
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Model.Refuses = true;
  this->Bench.ExpectLost("does not accept what is sent to it");
  EXPECT_TRUE(Eventually([&] { return this->Model.GetForce() == 0.0; })) << "its effect ends";
  this->Model.Refuses = false;
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_EQ(this->Bench.State().GetFault(), GateReason::DeviceLost) << "not by itself";
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(Wheel, WithASerialNumberItComesBackAndWaitsForTheUser)
{
  this->Evdev.reset();
  this->Model.Serial = "G29 0001";
  this->Evdev.emplace(this->Model);
  ASSERT_NO_FATAL_FAILURE(this->Open());
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "wheel:046d:c24f:G29_0001");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Evdev->Unplug();
  this->Bench.ExpectLost("was unplugged. Plug it in again");
  this->Model.CloseFiles();
  const EmulatedEvdev again(this->Model);
  this->Bench.ExpectBack();
  EXPECT_TRUE(Eventually([&] { return this->Model.GetForce() == 0.0; }));
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Stop();
  this->Bench.Device->Close();
}

TEST_F(Wheel, WithoutASerialNumberItDoesNotComeBackByItself)
{
  ASSERT_NO_FATAL_FAILURE(this->Open());
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Evdev->Unplug();
  this->Bench.ExpectLost("was unplugged. Plug it in, then Open() and Start() it.");
  const EmulatedEvdev again(this->Model);
  EXPECT_TRUE(this->Bench.WaitForTicks(1500));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged. Plug it in, then Open() and Start() it."));
}
