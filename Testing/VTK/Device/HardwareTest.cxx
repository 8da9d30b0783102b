// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests an application's view of a device that needs preparation and can be lost: listing, options,
 * arming, loss and homing.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/PlayedHardware.h"

#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

using namespace devicetest;
using VolumeHaptics::DeviceStage;

namespace
{
class DeviceHardware : public DeviceTest
{
protected:
  DeviceHardware()
  {
    PlayedHardware::Add();
    this->Played.Stage = DeviceStage::Ready;
    this->Played.Homings = 0;
  }
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }
  bool ExpectStage(DeviceStage stage, int status, const char* words)
  {
    this->Played.Stage = stage;
    const bool holds = this->Wait([&] { return this->Device->GetStatus() == status; });
    EXPECT_TRUE(this->Says(words)) << this->Device->GetStatusText();
    return holds;
  }

  PlayedHardware& Played = PlayedHardware::Get();
};
} // namespace

TEST_F(DeviceHardware, IsEnumeratedByIdAndListedWithItsState)
{
  vtkStringArray* const ids = vtkHapticDevice::EnumerateDevices();
  EXPECT_EQ(ids->GetValue(0), "virtual");
  EXPECT_GE(ids->LookupValue("played:0"), 1);
  vtkNew<vtkTable> table;
  vtkHapticDevice::ListDevices(table);
  ASSERT_EQ(table->GetNumberOfRows(), ids->GetNumberOfValues());
  const vtkIdType row = ids->LookupValue("played:0");
  EXPECT_EQ(table->GetValueByName(row, "Id").ToString(), "played:0");
  EXPECT_EQ(table->GetValueByName(row, "Name").ToString(), "A device that a test plays");
  EXPECT_EQ(table->GetValueByName(row, "State").ToString(), "available");
}

TEST_F(DeviceHardware, KindsThatCannotBeHadAreListedWithTheCure)
{
  setenv("VOLUMEHAPTICS_VENDOR_PATH", "relative", 1);
  vtkNew<vtkTable> table;
  vtkHapticDevice::ListMissingKinds(table);
  unsetenv("VOLUMEHAPTICS_VENDOR_PATH");
  std::string state;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, "Kind").ToString() == "vendor")
    {
      state = table->GetValueByName(row, "State").ToString();
    }
  }
  EXPECT_NE(state.find("Name the whole path"), std::string::npos) << state;
}

TEST_F(DeviceHardware, OptionsReachIt)
{
  EXPECT_EQ(this->Device->GetNewtonsPerFullScale()[0], 100.0)
    << "unknown devices are taken for strong ones";
  this->Device->SetFirmwareFile("image.bin");
  this->Device->SetVendorPath("/a:/b");
  this->Device->SetHomingTime(7.0);
  this->Device->UseGuardOff();
  this->Device->SetNewtonsPerFullScale(3.0, -200.0);
  ASSERT_TRUE(this->Device->Open("played:0"));
  EXPECT_EQ(this->Played.Options.FirmwareFile, "image.bin");
  EXPECT_EQ(this->Played.Options.VendorPath, "/a:/b");
  EXPECT_EQ(this->Played.Options.HomingTime, 7.0);
  EXPECT_FALSE(this->Played.Options.UseGuard);
  EXPECT_EQ(this->Played.Options.NewtonsPerFullScale[0], 3.0);
  EXPECT_EQ(this->Played.Options.NewtonsPerFullScale[1], -100.0);
  EXPECT_EQ(this->Device->GetMaximumForce(), 3.0) << "half of what it can";
  this->Device->SetLights(5);
  EXPECT_EQ(this->Played.Lights, 5);
}

TEST_F(DeviceHardware, CannotBeArmedBeforeItIsReady)
{
  this->Played.Stage = DeviceStage::Homing;
  this->Begin("played:0");
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Firmware, vtkHapticDevice::FIRMWARE, "Firmware of"));
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Homing, vtkHapticDevice::HOMING, "as the test plays"));
  this->Device->Arm();
  this->ExpectError("can't be armed yet");
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Ready, vtkHapticDevice::READY, "Arm() lets force"));
  EXPECT_TRUE(this->WaitTicks(100));
  EXPECT_EQ(this->Played.Force, 0.0) << "being ready arms nothing";
  this->Device->Arm();
  EXPECT_TRUE(this->WaitForce());
}

TEST_F(DeviceHardware, ComesBackFromALossByTheUserOnly)
{
  this->Begin("played:0");
  this->Device->Arm();
  ASSERT_TRUE(this->WaitForce());
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Lost, vtkHapticDevice::FAULT, "lost: played:0"));
  EXPECT_TRUE(this->Wait([this] { return this->Played.Force == 0.0; }));
  this->Device->Arm();
  this->ExpectError("as the test plays it");
  this->Device->Home();
  EXPECT_EQ(this->Played.Homings, 1);
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Homing, vtkHapticDevice::HOMING, "Homing of"));
  // The device is back, but the fault persists until the device is armed again.
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Ready, vtkHapticDevice::FAULT, "Arm() again"));
  EXPECT_TRUE(this->WaitTicks(100));
  EXPECT_EQ(this->Played.Force, 0.0);
  this->Device->Arm();
  EXPECT_TRUE(this->WaitForce());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
}

TEST_F(DeviceHardware, PromisesNoForceOnceAHomingHasEndedIt)
{
  this->Begin("played:0");
  this->Device->Arm();
  ASSERT_TRUE(this->WaitForce());
  this->Device->BeginLongWork("the test homes it");
  EXPECT_TRUE(this->Wait([this] { return this->Says("comes back by itself"); }));
  EXPECT_TRUE(this->ExpectStage(DeviceStage::Homing, vtkHapticDevice::HOMING, "Homing of"));
  EXPECT_TRUE(this->WaitTicks(10)); // lets the loop notice the homing
  this->Played.Stage = DeviceStage::Ready;
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetStatus() != vtkHapticDevice::HOMING; }));
  EXPECT_TRUE(this->WaitTicks(10));
  EXPECT_FALSE(this->Says("comes back by itself")) << this->Device->GetStatusText();
  EXPECT_TRUE(this->Says("Arm() lets force"));
  this->Device->EndLongWork();
  EXPECT_TRUE(this->WaitTicks(100));
  EXPECT_EQ(this->Played.Force, 0.0);
}

TEST_F(DeviceHardware, TellsHowItIsTurned)
{
  this->Played.Turn = 0.5;
  this->Begin("played:0");
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetState()->GetTurnRate()[1] == 0.5; }));
  this->Played.Turn = 0.0;
}

TEST_F(DeviceHardware, AnUnknownIdAndNoNumberAreErrors)
{
  EXPECT_FALSE(this->Device->Open("player:0"));
  this->ExpectError("the kinds are");
  this->Device->SetNewtonsPerFullScale(NAN, 1.0);
  this->ExpectError("must be finite");
}
