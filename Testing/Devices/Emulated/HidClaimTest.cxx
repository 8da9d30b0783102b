// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests which devices are listed, which device an id opens, and that only one program can have a
 * device open.
 */

#include "Emulators/WoodenModel.h"
#include "StickRig.h"

#include <sys/fsuid.h>

using namespace emulated;

TEST(HidClaim, ABoardIsListedAndHearsNothingBeforeTheUserSaysThatItIsAWoodenHaptics)
{
  using Board = WoodenModel::Board;
  {
    WoodenModel other(Board::Teensy, "Some keyboard");
    const EmulatedHid hid(other);
    EXPECT_TRUE(ListDevices().empty());
    EXPECT_TRUE(Has(ErrorOf("wooden"), "No WoodenHaptics is plugged in. Plug it in"));
  }
  for (const Board board : { Board::Mbed, Board::Teensy })
  {
    WoodenModel model(board);
    const EmulatedHid hid(model);
    ASSERT_EQ(ListDevices().size(), 1U);
    EXPECT_EQ(ListDevices()[0].Id, "wooden:0");
    DeviceBench bench;
    ASSERT_TRUE(bench.Open("wooden")) << bench.Error;
    ASSERT_TRUE(bench.WaitForText("If it is a WoodenHaptics")) << bench.Text();
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Homing) << "it may be silent";
    bench.Device->Close();
    EXPECT_EQ(model.GetPackets(), 0);
    ASSERT_TRUE(bench.Open("wooden")) << bench.Error;
    ASSERT_TRUE(bench.WaitForText("rest pose"));
    bench.Device->Home();
    EXPECT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
  }
}

TEST(HidClaim, APolhemIsRefusedAsItHasAnotherGeometry)
{
  WoodenModel polhem(WoodenModel::Board::Teensy, "Polhem USB HID");
  const EmulatedHid hid(polhem);
  EXPECT_TRUE(ListDevices().empty());
  const std::string error = ErrorOf("wooden");
  EXPECT_TRUE(Has(error, ("Polhem USB HID (" + hid.GetNode() + ") can't be used").c_str()))
    << error;
  EXPECT_TRUE(Has(error, "linkage")) << error;
  EXPECT_TRUE(Has(error, "Plug in a WoodenHaptics instead")) << error;
  EXPECT_EQ(polhem.GetPackets(), 0);
  WoodenModel wooden;
  const EmulatedHid second(wooden);
  DeviceBench bench;
  EXPECT_TRUE(bench.Open("wooden")) << bench.Error;
}

TEST(HidClaim, ADeviceIsHeldByOneAlone)
{
  WoodenModel model;
  const EmulatedHid hid(model);
  DeviceBench first;
  ASSERT_TRUE(first.Open("wooden:0")) << first.Error;
  EXPECT_EQ(ListDevices()[0].State, "in use");
  EXPECT_TRUE(Has(ErrorOf("wooden:0"), "is in use. Close it where it is open")) << first.Error;
  first.Device->Close();
  EXPECT_EQ(ListDevices()[0].State, "available");
  DeviceBench second;
  EXPECT_TRUE(second.Open("wooden:0")) << second.Error;
}

TEST(HidClaim, TheSecondOfTwoSticksIsOpenedWhereTheFirstIsInUse)
{
  OpenFfboardModel models[2];
  const EmulatedHid first(models[0]);
  const EmulatedHid second(models[1]);
  DeviceOptions options;
  DeviceBench a;
  DeviceBench b;
  ASSERT_TRUE(a.Open("pid", options)) << a.Error;
  EXPECT_TRUE(Has(a.Device->GetName(), first.GetNode().c_str())) << a.Device->GetName();
  ASSERT_TRUE(b.Open("pid:1209:ffb0", options)) << b.Error;
  EXPECT_TRUE(Has(b.Device->GetName(), second.GetNode().c_str())) << b.Device->GetName();
  EXPECT_TRUE(Has(ErrorOf("pid"), "is in use"));
}

TEST(HidClaim, IdsThatOpenNothing)
{
  EXPECT_TRUE(Has(ErrorOf("pid"), "No force-feedback stick or wheel is plugged in. Plug it in"));
  EXPECT_TRUE(Has(ErrorOf("pid:1209:ffb0"), "No device with these numbers is plugged in"));
  EXPECT_TRUE(Has(ErrorOf("spacemouse"), "No SpaceMouse is plugged in. Plug it in"));
  for (const char* id : { "pid:", "pid:1209", "pid:1209:ffbx", "pid:1209-ffb0", "pid:1209:ffb00" })
  {
    EXPECT_TRUE(Has(ErrorOf(id), "give \"pid\", or \"pid:VVVV:PPPP\"")) << id;
  }
  EXPECT_TRUE(Has(ErrorOf("wooden:x"), "is not a device id"));
  DeviceOptions options;
  options.NewtonsPerFullScale = { 1.0, HUGE_VAL };
  EXPECT_TRUE(Has(ErrorOf("pid", options), "NewtonsPerFullScale has to be finite"));
  WoodenModel model;
  const EmulatedHid hid(model);
  EXPECT_TRUE(Has(ErrorOf("wooden:1"), "no WoodenHaptics with this number. Count from 0"));
  EXPECT_TRUE(
    Has(ErrorOf("pid:1234:0006"), "can't be used: No force feedback with this HID device"));
}

TEST(HidClaim, WithoutPermissionTheRuleIsSaid)
{
  OpenFfboardModel model;
  EmulatedHid hid(model);
  hid.SetPermissions(0);
  // Root may open all devices, so change the file system user, for this thread only.
  const int owner = setfsuid(65534);
  const char* const rule =
    "SUBSYSTEM==\"hidraw\", ATTRS{idVendor}==\"1209\", ATTRS{idProduct}==\"ffb0\"";
  const std::vector<DeviceListing> all = ListDevices();
  EXPECT_EQ(all.size(), 1U) << "it can be listed all the same";
  EXPECT_TRUE(!all.empty() && Has(all[0].State, rule));
  EXPECT_TRUE(Has(ErrorOf("pid"), rule));
  setfsuid(static_cast<uid_t>(owner));
}

/// Expects that the rule for Bluetooth names the kernel's own device. ATTRS{idVendor} would match
/// nothing, because the device has no USB parent (known from preFlight issue 244 and spnavcfg issue
/// 60).
TEST(HidClaim, ByBluetoothTheRuleNamesTheKernelsDevice)
{
  OpenFfboardModel model;
  model.IsBluetooth = true;
  EmulatedHid hid(model);
  hid.SetPermissions(0);
  const int owner = setfsuid(65534);
  const std::string error = ErrorOf("pid");
  setfsuid(static_cast<uid_t>(owner));
  EXPECT_TRUE(Has(error, "SUBSYSTEM==\"hidraw\", KERNELS==\"0005:1209:FFB0.*\", TAG+=\"uaccess\""))
    << error;
}
