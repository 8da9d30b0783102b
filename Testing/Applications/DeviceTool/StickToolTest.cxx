// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs volumehaptics-device with an emulated stick of 4 N at full scale. A gentle wall must stay
 * gentle if the stick's strength was not set.
 */

#include "Applications/DeviceTool/DeviceTool.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace emulated;

namespace
{
/// Presses into the wall and retracts. Returns the largest force (N) on the hand; `said` receives
/// the tool's output.
double PressedWith(std::vector<std::string> options, std::string& said)
{
  OpenFfboardModel model;
  model.Streams = true;
  const EmulatedHid hid(model);
  std::atomic<double> largest{ 0.0 };
  int steps = 0;
  const ModelClock clock(
    [&]
    {
      model.SetGoal(0.02 * std::cos(0.004 * steps++), 0.0);
      model.Step();
      largest = std::max(largest.load(), std::abs(model.GetForce()[0]));
    });
  options.insert(options.begin(), { "test", "pid", "--seconds", "4" });
  std::istringstream in("\n");
  std::ostringstream out;
  std::ostringstream errors;
  EXPECT_EQ(RunDeviceTool(options, in, out, errors), 0) << errors.str();
  said = out.str();
  return largest;
}
} // namespace

TEST(StickTool, PushesGentlyUntilItsStrengthIsSet)
{
  std::string said;
  const double force = PressedWith({}, said);
  EXPECT_GT(force, 0.0);
  EXPECT_LE(force, 0.041) << "a hundredth of what it can";
  EXPECT_NE(said.find("give it with --newtons"), std::string::npos) << said;
}

TEST(StickTool, PushesWithANewtonWhereItIsKnown)
{
  std::string said;
  const double force = PressedWith({ "--newtons", "4" }, said);
  EXPECT_GT(force, 0.5);
  EXPECT_LE(force, 1.01);
  EXPECT_EQ(said.find("give it with --newtons"), std::string::npos) << said;
}
