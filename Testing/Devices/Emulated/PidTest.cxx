// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a session with a force-feedback wheel: it is plugged in, feels a wall, is unplugged, and
 * feels the wall again.
 */

#include "StickRig.h"

using namespace emulated;
using Bytes = std::vector<std::uint8_t>;

TEST_F(Pid, FromPluggingInToFeelingAgain)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "pid:1209:ffb0");
  EXPECT_EQ(all[0].Name, "Emulated FFBoard F407VG (" + this->Hid.GetNode() + ")");
  EXPECT_EQ(all[0].State, "available");
  ASSERT_TRUE(this->Bench.Open("pid:1209:FFB0", this->Options)) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, FfbHandle::FullScale);
  EXPECT_EQ(ListDevices()[0].State, "in use");
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  // Expect these bytes: block 1, constant force, 100 ms, full gain, Direction Enable, 90.00
  // degrees. The effect is then started once, and the device gets its full gain.
  EXPECT_EQ(this->Model.GetLast(1),
    (Bytes{ 1, 1, 1, 100, 0, 0, 0, 0, 0, 0, 0, 255, 0, 4, 0x28, 0x23, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(this->Model.GetLast(10)[2], 1);
  EXPECT_EQ(this->Model.GetLast(13), (Bytes{ 13, 255 }));
  EXPECT_EQ(this->Model.GetResets(), 2);

  this->Model.Buttons = 5;
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Buttons == 5U; }));
  EXPECT_TRUE(this->Bench.WaitForTicks(5000));

  // Unplug the device during contact. The force is cut off, the text says so, and the device's
  // effects end by themselves.
  this->Hid.Unplug();
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::DeviceLost));
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged."));
  EXPECT_TRUE(Eventually([&] { return this->Model.CountPlaying() == 0; }));
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);

  this->Model.PowerUp();
  this->Model.Buttons = 0;
  this->Hid.PlugIn();
  this->Bench.ExpectBack();
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_EQ(this->Model.CountEffects(), 0);
  EXPECT_EQ(this->Model.GetLast(5)[2] | this->Model.GetLast(5)[3], 0);
  EXPECT_EQ(this->Model.GetLast(12), (Bytes{ 12, 8 }));
}

TEST_F(Pid, KeepsItsIdentityByASerialNumber)
{
  EXPECT_EQ(ListDevices()[0].Identity.rfind("pid:1209:ffb0:SN", 0), 0U);
  ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
  EXPECT_TRUE(this->Bench.Device->KeepsIdentity());
  this->Bench.Device->Close();

  this->Hid.Unplug();
  this->Model.TellsSerial = false;
  this->Hid.PlugIn();
  EXPECT_EQ(ListDevices()[0].Identity, "");
  ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "pid:1209:ffb0") << "it has signs, however";
  EXPECT_FALSE(this->Bench.Device->KeepsIdentity());
}
