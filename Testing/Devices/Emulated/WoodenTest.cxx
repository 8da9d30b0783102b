// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a session with a WoodenHaptics: it is plugged in, feels a floor, is unplugged, and feels
 * the floor again.
 */

#include "WoodenRig.h"

using namespace emulated;

TEST_F(Wooden, IsNotReadyBeforeItIsToldItsRestPose)
{
  // After power-on, the device reports encoder counts of 0, which the driver must not mistake for a
  // known position.
  ASSERT_TRUE(this->Bench.Open("wooden")) << this->Bench.Error;
  this->Bench.Start(this->Ground.Model);
  this->Bench->Arm();
  ASSERT_TRUE(this->Bench.WaitForTicks(200));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  EXPECT_TRUE(
    Has(this->Bench.Text(), "put the arm into its rest pose, hold it still, and press Home()"));
  EXPECT_EQ(this->Bench.State().Device, DeviceState::NotReady);
  EXPECT_FALSE(this->Bench.State().IsArmed());
  // The calibration of an earlier session is no longer valid, because the device may have lost
  // power since then.
  this->Bench.Stop();
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  ASSERT_TRUE(this->Bench.Reopen()) << this->Bench.Error;
  EXPECT_TRUE(this->Bench.WaitForText("rest pose")) << this->Bench.Text();
}

TEST_F(Wooden, AZeroThatAnotherPacketOvertakesIsToldAgain)
{
  this->Model.MissedPresets = 2;
  ASSERT_TRUE(this->Bench.Open("wooden")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("rest pose"));
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_EQ(this->Model.GetPresets(), 3);
}

TEST_F(Wooden, OneThatSaysWhatItIsIsAskedAtOnce)
{
  WoodenModel named(WoodenModel::Board::Teensy, "woodenhaptics v2015");
  const EmulatedHid hid(named);
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("wooden:1")) << bench.Error;
  EXPECT_TRUE(bench.WaitForText("needs to know where its arm is")) << bench.Text();
  EXPECT_GT(named.GetPackets(), 0);
}

TEST_F(Wooden, FromPluggingInToFeelingAgain)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "wooden:0");
  EXPECT_EQ(all[0].Name, "Emulated HID DEVICE (" + this->Hid.GetNode() + ")");
  EXPECT_EQ(all[0].State, "available");
  ASSERT_TRUE(this->Bench.Open("wooden")) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 2.5);
  EXPECT_EQ(ListDevices()[0].State, "in use");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_EQ(this->Model.GetPresets(), 1);

  // Slide along the floor. Friction resists the hand.
  this->Bench->SetRecording(true);
  this->Model.SetGoal({ 0.0, 0.03, Height - 0.01 });
  EXPECT_TRUE(Eventually([&] { return this->Model.GetTip()[1] > 0.027; }));
  int sliding = 0;
  double slowest = 0.0;
  ServoSnapshot s;
  while (this->Bench->Drain(s))
  {
    if (s.Record.Contact == ContactState::Sliding)
    {
      ++sliding;
      EXPECT_LE(std::abs(s.Record.Force.X), Friction * s.Record.Force.Y + 1e-3);
      slowest = std::min(slowest, s.Record.Force.X / s.Record.Force.Y);
    }
  }
  EXPECT_GT(sliding, 20);
  EXPECT_NEAR(slowest, -Friction, 0.01);
  EXPECT_TRUE(this->Bench.WaitForTicks(5000));
  EXPECT_LT(this->Model.GetForce()[1], 0.0);

  // Unplug the device during contact. The force is cut off, the text says so, and the device does
  // not resume by itself.
  this->Hid.Unplug();
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::DeviceLost));
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged."));
  EXPECT_TRUE(ListDevices().empty());
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForTicks(50));
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));

  this->Model.PowerUp();
  this->Hid.PlugIn();
  this->Bench.ExpectBack();
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
  EXPECT_EQ(this->Model.GetLastPacket(), std::vector<std::uint8_t>(15, 0));
}
