// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests six-axis mice with faults.
 */

#include "DeviceBench.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/SpaceMouseModel.h"

#include <gtest/gtest.h>

using namespace emulated;

TEST(SpaceMouse, AReportOfAnotherModelAndALightThatIsNone)
{
  SpaceMouseModel model(false);
  model.HasNoLight = true;
  const EmulatedHid hid(model);
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("spacemouse:0")) << bench.Error;
  ASSERT_TRUE(bench.WaitFor(DeviceStage::Ready)) << "a light is not worth losing it for";
  model.SendRaw({ 1, 0, 0, 0, 0 });
  EXPECT_TRUE(bench.WaitForText("a report 1 that has neither 7 nor 13 bytes")) << bench.Text();
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Lost);
}

TEST(SpaceMouse, WhereLettingGoIsNotHeardTheTipDoesNotGoOn)
{
  SpaceMouseModel model(true);
  const EmulatedHid hid(model);
  const ModelClock clock([&] { model.Step(); });
  const Floor ground(0.0);
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("spacemouse")) << bench.Error;
  bench.Start(ground.Model);
  model.Push({ 0, 0, 0, 0, 350, 0 });
  const auto turns = [&](double rate)
  { return Eventually([&] { return std::abs(bench.State().Turn.Z - rate) < 1e-9; }); };
  EXPECT_TRUE(turns(1.0));
  // While the cap is deflected, the mouse repeats its report, so the rotation continues.
  EXPECT_TRUE(bench.WaitForTicks(1500));
  EXPECT_TRUE(turns(1.0));
  model.IsSilent = true;
  EXPECT_TRUE(turns(0.0));
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Ready) << "they are silent at rest";
}
