// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Unplugs or closes a device at arbitrary moments. */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
class FalconUnplugged : public FalconTest
{
protected:
  void ExpectGoneAndBack()
  {
    EXPECT_TRUE(this->IsAt(DeviceStage::Lost));
    EXPECT_TRUE(Has(this->GetText(), "was unplugged. Plug it in again")) << this->GetText();
    this->Device->Home();
    const long packets = this->Falcon.GetPackets();
    EXPECT_TRUE(Eventually([&] { return Has(this->GetText(), "was unplugged"); }));
    EXPECT_EQ(this->Falcon.GetPackets(), packets);
    DeviceSample sample;
    EXPECT_EQ(this->Device->Read(0.001, sample), DeviceState::Lost);
    EXPECT_EQ(this->Device->Write({ 0.0, 0.0, 1.0 }), DeviceState::Lost);
    this->Usb.PlugIn();
    // The driver reconnects the device by itself, and the user homes it. The earlier force must not
    // act.
    this->Falcon.DrainLargestCommand();
    this->Home();
    EXPECT_EQ(this->Falcon.DrainLargestCommand(), 0.0);
    EXPECT_TRUE(this->Feels({ 0.0, 0.0, 1.0 }));
  }
};

class FalconUnpluggedLoading : public FalconUnplugged
{
protected:
  FalconUnpluggedLoading()
    : File(MakeImage(60000))
  {
    this->Falcon.SwitchOff();
    this->Falcon.SetImageSize(60000);
    this->Options.FirmwareFile = this->File.Path.string();
  }
  void BeginLoading()
  {
    ASSERT_TRUE(this->Open()) << this->Error;
    ASSERT_TRUE(Eventually([&] { return this->Falcon.GetImage().size() > 1000; }));
  }
  const TemporaryFile File;
};
} // namespace

TEST_F(FalconUnplugged, WhileHoming)
{
  ASSERT_TRUE(this->Open()) << this->Error;
  this->Usb.Unplug();
  this->ExpectGoneAndBack();
}

TEST_F(FalconUnplugged, UnderForce)
{
  this->MakeReady();
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  this->Usb.Unplug();
  this->ExpectGoneAndBack();
}

TEST_F(FalconUnplugged, WhenItIsLostAlready)
{
  this->MakeReady();
  this->Falcon.Break(FalconFault::LostZero);
  ASSERT_TRUE(this->IsAt(DeviceStage::Lost));
  this->Usb.Unplug();
  EXPECT_TRUE(Eventually([&] { return Has(this->GetText(), "unplugged"); }));
  this->Falcon.Break(FalconFault::None);
  this->ExpectGoneAndBack();
}

TEST_F(FalconUnpluggedLoading, TheFirmware)
{
  this->BeginLoading();
  this->Usb.Unplug();
  this->ExpectGoneAndBack();
  EXPECT_EQ(this->Falcon.GetImage(), MakeImage(60000));
}

TEST_F(FalconUnpluggedLoading, ClosedMeanwhile)
{
  this->BeginLoading();
  this->Device->Close();
  EXPECT_LT(this->Falcon.GetImage().size(), 60000u) << "it does not go on to the end";
  EXPECT_FALSE(this->Usb.IsClaimed());
  ASSERT_TRUE(this->Device->Open(this->Error)) << this->Error;
  this->Home();
}
