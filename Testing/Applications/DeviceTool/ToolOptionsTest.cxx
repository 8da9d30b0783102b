// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the command line of volumehaptics-device.
 */

#include "Applications/DeviceTool/ToolOptions.h"

#include <gtest/gtest.h>

namespace
{
std::string ErrorOf(const std::vector<std::string>& arguments)
{
  ToolOptions options;
  std::string error;
  return ReadToolOptions(arguments, options, error) ? "" : error;
}
} // namespace

TEST(ToolOptions, AreRead)
{
  ToolOptions options;
  std::string error;
  ASSERT_TRUE(ReadToolOptions(
    { "record", "--rate", "500", "pid:1209:ffb0", "a.csv", "--newtons", "2,-3", "--axis", "y",
      "--seconds", "1.5", "--homing-time", "9", "--firmware", "f.bin", "--vendor-path", "/a:/b" },
    options, error))
    << error;
  EXPECT_EQ(options.What, ToolOptions::Command::Record);
  EXPECT_EQ(options.Id, "pid:1209:ffb0");
  EXPECT_EQ(options.File, "a.csv");
  EXPECT_EQ(options.ServoRate, 500.0);
  EXPECT_TRUE(options.HasNewtons);
  EXPECT_EQ(options.Newtons[0], 2.0);
  EXPECT_EQ(options.Newtons[1], -3.0);
  EXPECT_EQ(options.Axis, 1);
  EXPECT_EQ(options.Seconds, 1.5);
  EXPECT_EQ(options.HomingTime, 9.0);
  EXPECT_EQ(options.Firmware, "f.bin");
  EXPECT_EQ(options.VendorPath, "/a:/b");
  ASSERT_TRUE(ReadToolOptions({ "monitor", "falcon", "--newtons", "-2" }, options, error));
  EXPECT_EQ(options.Newtons[1], -2.0) << "of both axes";
}

TEST(ToolOptions, OfACalibrationAreRead)
{
  ToolOptions options;
  std::string error;
  ASSERT_TRUE(ReadToolOptions({ "calibrate", "falcon", "--weight", "150" }, options, error));
  EXPECT_EQ(options.What, ToolOptions::Command::Calibrate);
  EXPECT_EQ(options.Grams, 150.0);
  options = {};
  ASSERT_TRUE(ReadToolOptions({ "calibrate", "--scale", "falcon", "--axis", "-z" }, options, error))
    << error;
  EXPECT_TRUE(options.HasScale);
  EXPECT_EQ(options.Axis, 2);
  EXPECT_TRUE(options.IsAxisNegative);
}

TEST(ToolOptions, HelpIsGivenWhereverItIsAskedFor)
{
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{ { "--help" },
         { "confirm", "--help" }, { "monitor", "falcon", "-h" }, { "calibrate", "--help" } })
  {
    ToolOptions options;
    std::string error;
    EXPECT_TRUE(ReadToolOptions(words, options, error)) << error;
    EXPECT_EQ(options.What, ToolOptions::Command::Help) << words.front();
  }
}

TEST(ToolOptions, AreRefusedWithWhatIsRight)
{
  const std::vector<std::pair<std::vector<std::string>, const char*>> wrong = {
    { {}, "No command was given" },
    { { "feel" }, "no command \"feel\"" },
    { { "monitor" }, "the id of a device" },
    { { "monitor", "falcon", "wooden" }, "the id of a device" },
    { { "record", "falcon" }, "a file named .vtp or .csv" },
    { { "list", "falcon" }, "no operands" },
    { { "monitor", "falcon", "--speed", "1" }, "There is no option \"--speed\"" },
    { { "monitor", "falcon", "--rate" }, "--rate wants Hz" },
    { { "monitor", "falcon", "--rate", "50" }, "100 to 10000" },
    { { "monitor", "falcon", "--rate", "1000x" }, "100 to 10000" },
    { { "monitor", "falcon", "--newtons", "1,2,3" }, "such as 2.5" },
    { { "monitor", "falcon", "--newtons", "nan" }, "such as 2.5" },
    { { "test", "falcon", "--axis", "xy" }, "x, y or z" },
    { { "test", "falcon", "--axis", "-x" }, "x, y or z" },
    { { "calibrate", "falcon", "--axis", "-" }, "x, y or z" },
    { { "calibrate", "falcon" }, "either --weight GRAMS or --scale" },
    { { "calibrate", "falcon", "--scale", "--weight", "50" }, "either --weight GRAMS or --scale" },
    { { "calibrate", "falcon", "--weight", "heavy" }, "grams, 5 to 5000" },
    { { "calibrate", "falcon", "--weight", "1" }, "grams, 5 to 5000" },
    { { "monitor", "falcon", "--scale" }, "are for calibrate" },
    { { "test", "falcon", "--seconds", "0" }, "more than 0" },
    { { "home", "falcon", "--homing-time", "0" }, "1 to 3600" },
  };
  for (const auto& [arguments, words] : wrong)
  {
    const std::string error = ErrorOf(arguments);
    EXPECT_NE(error.find(words), std::string::npos) << error << " instead of " << words;
  }
}
