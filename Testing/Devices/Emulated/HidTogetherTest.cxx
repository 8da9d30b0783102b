// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests two different devices at the same time, each with its own loop: neither affects the other.
 */

#include "Emulators/SpaceMouseModel.h"
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

/// A six-axis mouse, whose cap moves a tip and exerts no force.
struct MousePart
{
  SpaceMouseModel Model{ SpaceMouseModel::Kind::Compact };
  EmulatedHid Hid{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  Floor Ground{ 0.0 };
  DeviceBench Bench;
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
  // Unplug the hub with both devices. The second device is plugged in first.
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

TEST(HidTogether, AHubThatLosesAllGivesEachBackWithoutForce)
{
  WoodenPart arms[2];
  StickPart stick;
  MousePart mice[2];
  ASSERT_TRUE(stick.Bench.Open("pid", stick.Options)) << stick.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(stick.Feel());
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_TRUE(arms[i].Bench.Open("wooden:" + std::to_string(i))) << arms[i].Bench.Error;
    ASSERT_NO_FATAL_FAILURE(arms[i].Feel());
    ASSERT_NO_FATAL_FAILURE(
      mice[i].Bench.Begin("spacemouse:" + std::to_string(i), mice[i].Ground.Model));
  }
  ASSERT_NE(arms[0].Bench.Device->GetIdentity(), arms[1].Bench.Device->GetIdentity());
  EXPECT_EQ(ListDevices().size(), 5U);

  stick.Hid.Unplug();
  for (int i = 0; i < 2; ++i)
  {
    arms[i].Hid.Unplug();
    mice[i].Hid.Unplug();
  }
  EXPECT_TRUE(ListDevices().empty());
  EXPECT_TRUE(stick.Bench.WaitForFault(GateReason::DeviceLost));
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(arms[i].Bench.WaitForFault(GateReason::DeviceLost));
    EXPECT_TRUE(mice[i].Bench.WaitForFault(GateReason::DeviceLost));
    arms[i].Model.PowerUp();
  }
  stick.Model.PowerUp();

  // The second one of each kind is found first.
  for (int i = 1; i >= 0; --i)
  {
    mice[i].Hid.PlugIn();
    mice[i].Bench.ExpectBack();
    arms[i].Hid.PlugIn();
    arms[i].Bench.ExpectBack();
    EXPECT_EQ(Size(arms[i].Model.GetForce()), 0.0);
    if (i == 1)
    {
      EXPECT_EQ(arms[0].Bench.Device->GetCondition().Stage, DeviceStage::Lost) << "not its twin";
      EXPECT_EQ(mice[0].Bench.Device->GetCondition().Stage, DeviceStage::Lost) << "not its twin";
    }
  }
  stick.Hid.PlugIn();
  stick.Bench.ExpectBack();
  EXPECT_EQ(Size(stick.Model.GetForce()), 0.0);
  // Only one of them is armed.
  arms[0].Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(arms[0].Feel());
  EXPECT_EQ(Size(arms[1].Model.GetForce()), 0.0);
  EXPECT_EQ(Size(stick.Model.GetForce()), 0.0);
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
  // The stick that was plugged in may be a different one, whose force has the opposite sign, so it
  // must not reconnect by itself.
  EXPECT_TRUE(stick.Bench.WaitForTicks(1500));
  EXPECT_EQ(stick.Bench.Device->GetCondition().Stage, DeviceStage::Lost);
}
