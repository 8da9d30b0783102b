// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests an application in which a hand presses an emulated Falcon onto the phantom's face. */

#include "PhantomFalconRig.h"

#include <fstream>

using namespace emulated;

TEST_F(PhantomFalcon, IsFeltLostAndFeltAgain)
{
  EXPECT_FALSE(this->Device->Open("falcon"));
  ASSERT_EQ(this->Log.Errors.size(), 1u);
  EXPECT_NE(this->Log.Errors[0].find("SetFirmwareFile"), std::string::npos) << this->Log.Errors[0];
  this->Log.Errors.clear();
  const std::string firmware = TemporaryPath("PhantomFalcon.bin");
  std::ofstream(firmware, std::ios::binary) << std::string(4000, 'F');
  this->Device->SetFirmwareFile(firmware);

  // The boot loader does not answer until the test has read the status. Otherwise the firmware
  // might already be loaded by then.
  this->Falcon.Break(FalconFault::NoGreeting);
  ASSERT_TRUE(this->Device->Open("falcon"));
  ASSERT_TRUE(this->Device->Start());
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Hand.Says("Firmware of falcon"); }))
    << this->Device->GetStatusText();
  this->Falcon.Break(FalconFault::None);
  ASSERT_NO_FATAL_FAILURE(this->Home());
  EXPECT_EQ(this->Falcon.GetImage(), std::vector<std::uint8_t>(4000, 'F'));
  const vtkIdType from = this->Device->GetState()->GetTick();
  for (const double x : { 0.0, 0.01, -0.01, 0.0 })
  {
    ASSERT_NO_FATAL_FAILURE(this->Press(x, x, 0.006));
    EXPECT_TRUE(this->LeadTo(0.5 * x, x, this->HeightOfSkin(0.5 * x, x) - 0.004)) << "sliding back";
    EXPECT_TRUE(this->Hand.WaitTicks(1500));
  }
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Device->GetState()->GetTick() >= from + 5000; }));
  ASSERT_NO_FATAL_FAILURE(this->Press(0.0, 0.0, 0.006));

  this->Usb.Unplug();
  EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(this->Hand.Says("unplugged")) << this->Device->GetStatusText();
  EXPECT_TRUE(this->Hand.WaitTicks(5));
  this->ExpectNoForce(20);
  this->Falcon.SwitchOff();
  this->Usb.PlugIn();
  // The device is opened again automatically, and receives its firmware. Then the hand homes it.
  ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::HOMING)) << this->Device->GetStatusText();
  ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.1735));
  ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.08));
  ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.172));
  ASSERT_TRUE(this->Hand.Wait([this] { return this->Hand.Says("is back. Arm() again"); }))
    << this->Device->GetStatusText();
  this->ExpectNoForce(200);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::FAULT) << "no force comes back by itself";
  ASSERT_NO_FATAL_FAILURE(this->Press(0.0, 0.0, 0.006));
  this->Device->Close();
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
}
