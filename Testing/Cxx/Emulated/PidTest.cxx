// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A session with a force-feedback stick: from plugging it in to feeling a wall, and again after it was unplugged.
 */

#include "StickRig.h"

using namespace emulated;
using Bytes = std::vector<std::uint8_t>;

TEST_F(Pid, FromPluggingInToFeelingAgain)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "pid:1209:ffb0");
  EXPECT_EQ(all[0].Name, "Emulated FFB Stick (" + this->Hid.GetNode() + ")");
  EXPECT_EQ(all[0].State, "available");
  ASSERT_TRUE(this->Bench.Open("pid:1209:FFB0", this->Options)) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, StickModel::FullScale);
  EXPECT_EQ(ListDevices()[0].State, "in use");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  // To the byte: block 2, constant, 100 ms, full gain, its axis, 180 degrees; started once; full gain of the device.
  EXPECT_EQ(this->Model.GetLast(2), (Bytes{ 2, 2, 1, 100, 0, 255, 2, 180, 0 }));
  EXPECT_EQ(this->Model.GetLast(10)[2], 1);
  EXPECT_EQ(this->Model.GetLast(13), (Bytes{ 13, 255 }));
  EXPECT_EQ(this->Model.GetResets(), 2);

  // It slides away from the hand: friction pulls back.
  this->Model.Buttons = 5;
  this->Model.SetGoal(Wall + 0.01, 0.03);
  EXPECT_TRUE(Eventually([&] { return this->Model.GetTip()[1] > 0.02; }));
  EXPECT_TRUE(this->Bench.WaitForTicks(5000));
  const Triple force = this->Model.GetForce();
  EXPECT_LT(force[1], -0.5 * Friction * std::abs(force[0]));
  EXPECT_GE(force[1], -Friction * std::abs(force[0]) - 0.02);
  this->Bench->ReadState();
  EXPECT_EQ(this->Bench->GetState().Buttons, 5U);

  // Unplugged in contact: cut, said; its effects end by themselves.
  this->Hid.Unplug();
  EXPECT_TRUE(this->Bench.WaitForFault(SafetyFault::DeviceLost));
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged. Plug it in, then Open() and Start() it."));
  EXPECT_TRUE(Eventually([&] { return this->Model.CountPlaying() == 0; }));
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
  this->Bench.Stop();

  this->Model.PowerUp();
  this->Model.Buttons = 0;
  this->Hid.PlugIn();
  ASSERT_TRUE(this->Bench.Reopen()) << this->Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_EQ(this->Model.CountEffects(), 0);
  EXPECT_EQ(this->Model.GetLast(5)[2] | this->Model.GetLast(5)[3], 0);
  EXPECT_EQ(this->Model.GetLast(12), (Bytes{ 12, 4 }));
}
