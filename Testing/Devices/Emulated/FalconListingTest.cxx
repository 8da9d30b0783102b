// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests which devices are listed, which of them may be opened, and which are in use.
 */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
class FalconListing : public FalconTest
{
protected:
  std::vector<DeviceListing> List()
  {
    std::vector<DeviceListing> falcons;
    for (const DeviceListing& listing : ListDevices())
    {
      if (Has(listing.Id, "falcon"))
      {
        falcons.push_back(listing);
      }
    }
    return falcons;
  }
  void ExpectError(const std::string& id, const std::string& part)
  {
    EXPECT_FALSE(this->Open(id));
    EXPECT_TRUE(Has(this->Error, part)) << this->Error;
  }
};
} // namespace

TEST_F(FalconListing, InTheOrderOfThePorts)
{
  FalconModel far;
  FalconModel near;
  const EmulatedUsb second(far, "2-1");
  const EmulatedUsb first(near, "1-1");
  const std::vector<DeviceListing> all = this->List();
  ASSERT_EQ(all.size(), 3u);
  const char* const names[] = { "Novint Falcon (USB bus 1, port 1)",
    "Novint Falcon (USB bus 1, port 2)", "Novint Falcon (USB bus 2, port 1)" };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(all[i].Id, "falcon:" + std::to_string(i));
    EXPECT_EQ(all[i].Name, names[i]);
    EXPECT_EQ(all[i].State, "available");
  }
  ASSERT_TRUE(this->Open("falcon:2")) << this->Error;
  EXPECT_EQ(this->Device->GetName(), names[2]);
  EXPECT_TRUE(Eventually([&] { return far.GetPackets() > 10; }));
  EXPECT_EQ(near.GetPackets() + this->Falcon.GetPackets(), 0);
}

TEST_F(FalconListing, EachIsRememberedByItsPortIfItHasNoSerialNumber)
{
  FalconModel other;
  const EmulatedUsb port(other, "1-7");
  const std::vector<DeviceListing> all = this->List();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].Identity, "falcon:port:1-2");
  EXPECT_EQ(all[1].Identity, "falcon:port:1-7");
  for (const bool guarded : { true, false })
  {
    this->Options.UseGuard = guarded;
    ASSERT_TRUE(this->Open("falcon:1")) << this->Error;
    EXPECT_EQ(this->Device->GetIdentity(), "falcon:port:1-7");
    this->Device->Close();
  }
}

TEST_F(FalconListing, TwoAtOnce)
{
  FalconModel other;
  const EmulatedUsb port(other, "1-7");
  this->MakeReady();
  const std::unique_ptr<DeviceBackend> second = MakeDevice("falcon:1", this->Options, this->Error);
  ASSERT_TRUE(second && second->Open(this->Error)) << this->Error;
  for (const double z : { 0.1735, 0.08, 0.1735 })
  {
    other.SetAim({ 0.0, 0.0, z });
    ASSERT_TRUE(Eventually([&] { return AreClose(other.GetGrip(), { 0.0, 0.0, z }, 0.001); }));
  }
  EXPECT_TRUE(Eventually([&] { return second->GetCondition().Stage == DeviceStage::Ready; }));
  EXPECT_TRUE(this->Push({ 1.0, 0.0, 0.0 },
    [&]
    {
      DeviceSample sample;
      second->Read(0.001, sample);
      second->Write({ 0.0, -1.0, 0.0 });
      return AreClose(this->Falcon.GetForce(), { 1.0, 0.0, 0.0 }, 0.05) &&
        AreClose(other.GetForce(), { 0.0, -1.0, 0.0 }, 0.05);
    }));
}

TEST_F(FalconListing, TwoOfOneKindComeBackEachAsItself)
{
  FalconModel other;
  EmulatedUsb port(other, "1-7");
  this->MakeReady();
  const std::unique_ptr<DeviceBackend> second = MakeDevice("falcon:1", this->Options, this->Error);
  ASSERT_TRUE(second && second->Open(this->Error)) << this->Error;
  const auto isLost = [](DeviceBackend& device)
  { return Eventually([&] { return device.GetCondition().Stage == DeviceStage::Lost; }); };
  // Unplug the hub with both devices, and plug in the second device first.
  this->Usb.Unplug();
  port.Unplug();
  EXPECT_TRUE(isLost(*this->Device));
  EXPECT_TRUE(isLost(*second));
  port.PlugIn();
  EXPECT_TRUE(Eventually([&] { return second->GetCondition().Stage == DeviceStage::Homing; }))
    << second->GetCondition().Text.data();
  EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Lost) << "the other port is empty";
  this->Usb.PlugIn();
  this->Home();
  EXPECT_EQ(second->GetCondition().Stage, DeviceStage::Homing) << "its grip was not moved";
  EXPECT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
  EXPECT_TRUE(AreClose(other.GetForce(), { 0.0, 0.0, 0.0 }, 1e-9));
}

TEST_F(FalconListing, InUse)
{
  this->MakeReady();
  ASSERT_EQ(this->List().size(), 1u);
  EXPECT_EQ(this->List()[0].State, "in use");
  const std::unique_ptr<DeviceBackend> first = std::move(this->Device);
  this->ExpectError("falcon", "in use");
  this->Device = nullptr;
  EXPECT_EQ(first->GetCondition().Stage, DeviceStage::Ready) << "the first one goes on";
  first->Close();
  EXPECT_EQ(this->List()[0].State, "available");
  EXPECT_TRUE(this->Open()) << this->Error;
}

TEST_F(FalconListing, NotThere)
{
  this->ExpectError("falcon:1", "no Novint Falcon of number 1");
  this->ExpectError("falcon:x", "N counting from 0");
  this->Usb.Unplug();
  EXPECT_TRUE(this->List().empty());
  this->ExpectError("falcon", "No Novint Falcon is plugged in");
  this->Usb.PlugIn();
  EXPECT_TRUE(this->Open()) << this->Error;
}

TEST_F(FalconListing, ADriverOfTheKernelGivesWayAndComesBack)
{
  this->Usb.BindDriver("ftdi_sio");
  EXPECT_EQ(this->List()[0].State, "available");
  EXPECT_EQ(this->Usb.GetDriver(), "ftdi_sio") << "listing leaves it";
  ASSERT_TRUE(this->Open()) << this->Error;
  EXPECT_EQ(this->Usb.GetDriver(), "");
  this->Device->Close();
  EXPECT_EQ(this->Usb.GetDriver(), "ftdi_sio");
}
