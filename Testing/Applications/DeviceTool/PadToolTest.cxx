// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs volumehaptics-device with an emulated gamepad: the listing says that the pad only vibrates,
 * the wall is rendered as vibration, and the tool requests neither confirmation nor calibration.
 */

#include "Applications/DeviceTool/DeviceTool.h"
#include "Emulators/EmulatedEvdev.h"
#include "Emulators/ModelClock.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

using namespace emulated;

namespace
{
struct Told
{
  int Status = 0;
  std::string Out;
  std::string Errors;
};

Told RunTool(const std::vector<std::string>& options)
{
  std::istringstream in("\n");
  std::ostringstream out;
  std::ostringstream errors;
  Told told;
  told.Status = RunDeviceTool(options, in, out, errors);
  told.Out = out.str();
  told.Errors = errors.str();
  return told;
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(PadTool, NamesItForWhatItIs)
{
  EXPECT_TRUE(Has(RunTool({ "list" }).Out, "vibration         can't be used yet:\n"))
    << "without a pad";
  PadModel pad(PadModel::Kind::Xbox);
  const EmulatedEvdev evdev(pad);
  const Told list = RunTool({ "list" });
  EXPECT_EQ(list.Status, 0);
  EXPECT_TRUE(Has(list.Out, "vibration:pad:0   Microsoft X-Box 360 pad")) << list.Out;
  EXPECT_TRUE(Has(list.Out, ": vibration, not force\n")) << list.Out;
  EXPECT_FALSE(Has(list.Out, "uncalibrated")) << list.Out;
  EXPECT_TRUE(Has(RunTool({ "confirm", "vibration:pad" }).Errors, "there is nothing to confirm"));
  EXPECT_TRUE(Has(
    RunTool({ "calibrate", "vibration:pad", "--scale" }).Errors, "there is nothing to calibrate"));
}

TEST(PadTool, ItsWallIsFeltAsVibration)
{
  PadModel pad(PadModel::Kind::Xbox);
  const EmulatedEvdev evdev(pad);
  const ModelClock clock([&pad] { pad.StepInAndOut(); }); // into the wall and out of it
  const Told test = RunTool({ "test", "vibration:pad", "--seconds", "3" });
  EXPECT_EQ(test.Status, 0) << test.Errors;
  EXPECT_TRUE(Has(test.Out, "It can't push: its contact is vibration.")) << test.Out;
  EXPECT_FALSE(Has(test.Out, "It pushes")) << test.Out;
  EXPECT_FALSE(pad.GetHistory().empty());
  EXPECT_TRUE(pad.IsStill()) << "at its end";
}
