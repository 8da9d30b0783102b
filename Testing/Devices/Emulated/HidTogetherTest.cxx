// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Two different devices at once, each with its own loop: neither disturbs the other.
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
