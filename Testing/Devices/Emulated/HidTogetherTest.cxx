// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests two different devices at once, each with its own loop: neither disturbs the other.
 */

#include "StickRig.h"
#include "WoodenRig.h"

using namespace emulated;

namespace
{
class WoodenPart : public Wooden
{
public:
  void TestBody() override {}
  using Wooden::Bench;
  using Wooden::Feel;
  using Wooden::Hid;
  using Wooden::Model;
};

class StickPart : public Pid
{
public:
  void TestBody() override {}
  using Pid::Bench;
  using Pid::Feel;
  using Pid::Hid;
  using Pid::Model;
  using Pid::Options;
};
} // namespace

TEST(HidTogether, OneGoesOnWhereTheOtherIsUnplugged)
{
  WoodenPart arm;
  StickPart stick;
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].Id, "wooden:0");
  EXPECT_EQ(all[1].Id, "pid:1209:ffb0");
  ASSERT_TRUE(arm.Bench.Open("wooden")) << arm.Bench.Error;
  ASSERT_TRUE(stick.Bench.Open("pid", stick.Options)) << stick.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(arm.Feel());
  ASSERT_NO_FATAL_FAILURE(stick.Feel());
  EXPECT_TRUE(arm.Bench.WaitForTicks(1000));
  EXPECT_GT(arm.Model.GetForce()[2], 1.5);
  EXPECT_LT(stick.Model.GetForce()[0], -1.5);

  arm.Hid.Unplug();
  EXPECT_TRUE(arm.Bench.WaitForFault(GateReason::DeviceLost));
  EXPECT_TRUE(stick.Bench.WaitForTicks(200));
  EXPECT_TRUE(stick.Bench.WaitForFault(GateReason::None));
  EXPECT_LT(stick.Model.GetForce()[0], -1.5);
}

TEST(HidTogether, TwoOfOneKindComeBackEachAsItself)
{
  StickPart first;
  StickPart second;
  ASSERT_TRUE(first.Bench.Open("pid", first.Options)) << first.Bench.Error;
  ASSERT_TRUE(second.Bench.Open("pid", second.Options)) << second.Bench.Error;
  const std::string one = first.Bench.Device->GetIdentity();
  ASSERT_NE(one, second.Bench.Device->GetIdentity());
  ASSERT_NO_FATAL_FAILURE(first.Feel());
  ASSERT_NO_FATAL_FAILURE(second.Feel());
  // Unplug the hub with both devices. The second device comes back first.
  first.Hid.Unplug();
  second.Hid.Unplug();
  EXPECT_TRUE(first.Bench.WaitForFault(GateReason::DeviceLost));
  EXPECT_TRUE(second.Bench.WaitForFault(GateReason::DeviceLost));
  first.Model.PowerUp();
  second.Model.PowerUp();
  second.Hid.PlugIn();
  second.Bench.ExpectBack();
  EXPECT_EQ(first.Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  first.Hid.PlugIn();
  first.Bench.ExpectBack();
  first.Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(first.Feel());
  EXPECT_EQ(Size(second.Model.GetForce()), 0.0) << "it was not armed";
  EXPECT_EQ(first.Bench.Device->GetIdentity(), one);
}

TEST(HidTogether, AStickIsNotMistakenForItsTwinWithTheSameSerialNumber)
{
  StickPart stick;
  OpenFfboardModel other;
  ASSERT_TRUE(stick.Bench.Open("pid", stick.Options)) << stick.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(stick.Feel());
  const EmulatedHid twin(other, stick.Hid.GetSerialNumber());
  stick.Hid.Unplug();
  stick.Bench.ExpectLost("was unplugged. Plug it in, then Open() and Start() it.");
  EXPECT_TRUE(stick.Bench.WaitForTicks(1500));
  EXPECT_EQ(stick.Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  EXPECT_EQ(other.CountPlaying(), 0);
}

TEST(HidTogether, AStickWithoutASerialNumberDoesNotComeBackByItself)
{
  StickPart stick;
  stick.Hid.Unplug();
  stick.Model.TellsSerial = false;
  stick.Hid.PlugIn();
  ASSERT_TRUE(stick.Bench.Open("pid", stick.Options)) << stick.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(stick.Feel());
  stick.Hid.Unplug();
  stick.Bench.ExpectLost("was unplugged. Plug it in, then Open() and Start() it.");
  stick.Hid.PlugIn();
  // The newly plugged stick may be a different stick, whose force has the opposite sign. So it is
  // not used by itself.
  EXPECT_TRUE(stick.Bench.WaitForTicks(1500));
  EXPECT_EQ(stick.Bench.Device->GetCondition().Stage, DeviceStage::Lost);
}
