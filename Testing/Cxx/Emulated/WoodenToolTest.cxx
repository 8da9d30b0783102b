// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * volumehaptics-device with an emulated WoodenHaptics, whose zero somebody has to tell by pressing Enter.
 */

#include "DeviceTool.h"
#include "EmulatedHid.h"
#include "WoodenModel.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace emulated;

namespace
{
class WoodenToolTest : public testing::Test
{
protected:
  int Run(const std::vector<std::string>& arguments, const std::string& typed)
  {
    std::istringstream in(typed);
    std::ostringstream out;
    std::ostringstream errors;
    const int result = RunDeviceTool(arguments, in, out, errors);
    this->Out = out.str();
    this->Errors = errors.str();
    return result;
  }
  bool Asks() { return this->Out.find("hold it there and press Enter") != std::string::npos; }

  WoodenModel Model;
  EmulatedHid Hid{ this->Model };
  std::string Out;
  std::string Errors;
};
} // namespace

TEST_F(WoodenToolTest, IsCalibratedAfterEnterAndOnceIsEnough)
{
  const std::vector<std::string> monitor{ "monitor", "wooden", "--seconds", "0.2" };
  EXPECT_EQ(this->Run(monitor, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Asks()) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 1);
  // Now it knows where its arm is.
  EXPECT_EQ(this->Run(monitor, ""), 0) << this->Errors;
  EXPECT_FALSE(this->Asks()) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 1);
}

TEST_F(WoodenToolTest, HomesOneThatHasAZeroAnew)
{
  EXPECT_EQ(this->Run({ "home", "wooden" }, "\n"), 0) << this->Errors;
  EXPECT_EQ(this->Model.GetPresets(), 1);
  EXPECT_EQ(this->Run({ "home", "wooden" }, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Asks()) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 2);
  EXPECT_EQ(this->Run({ "home", "wooden" }, ""), 1);
  EXPECT_NE(this->Errors.find("Nobody pressed Enter"), std::string::npos) << this->Errors;
  EXPECT_EQ(this->Model.GetPresets(), 2) << "nobody said that the arm rests";
}

TEST_F(WoodenToolTest, AsksAgainWhereTheZeroIsNotTaken)
{
  this->Model.IgnoresPresets = true;
  EXPECT_EQ(this->Run({ "home", "wooden" }, "\n\n"), 1);
  EXPECT_NE(this->Out.find("did not take in where its arm is"), std::string::npos) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 2);
}
