// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the command lines of the documentation pages of wheels, gamepads and SpaceMice with emulated
 * devices. DeviceToolTest.cxx and WoodenToolTest.cxx cover Falcons and WoodenHaptics.
 */

#include "Emulators/EmulatedEvdev.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"
#include "Emulators/SpaceMouseModel.h"
#include "PageRig.h"

#include <atomic>
#include <cmath>

using namespace emulated;

namespace
{
using Pages = PageTest;
}

TEST_F(Pages, OfWheelsLeadToTheFirstForce)
{
  OpenFfboardModel model;
  model.Streams = true;
  const EmulatedHid hid(model);
  std::atomic<double> largest{ 0.0 };
  const ModelClock clock(
    [&]
    {
      model.Step();
      largest = std::max(largest.load(), std::abs(model.GetForce()[0]));
    });
  EXPECT_EQ(this->Type("wheels.md", "pid"), 5) << "with the list of the other kind of wheels";
  EXPECT_GT(largest, 0.0);
}

TEST_F(Pages, OfWheelsWithDriversOfLinuxLeadToTheFirstForce)
{
  PadModel model(PadModel::Kind::Wheel);
  const EmulatedEvdev evdev(model);
  std::atomic<double> largest{ 0.0 };
  const ModelClock clock(
    [&]
    {
      model.Step();
      largest = std::max(largest.load(), std::abs(model.GetForce()));
    });
  EXPECT_EQ(this->Type("wheels.md", "wheel"), 5) << "with the list of the other kind of wheels";
  EXPECT_GT(largest, 0.0);
}

TEST_F(Pages, OfGamepadsLeadToTheFirstTouch)
{
  PadModel pad(PadModel::Kind::Xbox);
  const EmulatedEvdev evdev(pad);
  const ModelClock clock([&pad] { pad.StepInAndOut(); });
  EXPECT_EQ(this->Type("gamepads.md", "vibration:pad"), 3);
  EXPECT_FALSE(pad.GetHistory().empty());
}

TEST_F(Pages, OfSpaceMiceLeadToTheFirstTouch)
{
  SpaceMouseModel model(SpaceMouseModel::Kind::Navigator);
  const EmulatedHid hid(model);
  EXPECT_EQ(this->Type("spacemouse.md", "spacemouse"), 2);
}
