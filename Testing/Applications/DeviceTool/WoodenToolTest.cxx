// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs volumehaptics-device with an emulated WoodenHaptics, whose zero the user confirms with
 * Enter.
 */

#include "Emulators/EmulatedHid.h"
#include "Emulators/WoodenModel.h"
#include "PageRig.h"

using namespace emulated;

namespace
{
class WoodenToolTest : public PageTest
{
protected:
  bool Asks() { return this->Shows("hold it there and press Enter"); }

  WoodenModel Model;
  EmulatedHid Hid{ this->Model };
};
} // namespace

TEST_F(WoodenToolTest, IsCalibratedAfterEnterWheneverItIsOpened)
{
  const std::vector<std::string> monitor{ "monitor", "wooden", "--seconds", "0.2" };
  EXPECT_EQ(this->Run(monitor, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Asks()) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 1);
  // The device can't report whether it has kept its zero, so the tool asks again.
  EXPECT_EQ(this->Run(monitor, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Asks()) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 2);
}

TEST_F(WoodenToolTest, TheLinesOfItsPageLeadToTheFirstForce)
{
  EXPECT_EQ(this->Type("woodenhaptics.md", "wooden"), 5) << "with the list of the other controller";
  EXPECT_EQ(this->Model.GetPresets(), 3);
}

TEST_F(WoodenToolTest, HomesOneThatHasAZeroAnew)
{
  EXPECT_EQ(this->Run({ "home", "wooden" }, "\n"), 0) << this->Errors;
  EXPECT_EQ(this->Model.GetPresets(), 1);
  EXPECT_EQ(this->Run({ "home", "wooden" }, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Asks()) << this->Out;
  EXPECT_EQ(this->Model.GetPresets(), 2);
  EXPECT_EQ(this->Run({ "home", "wooden" }, ""), 1);
  EXPECT_NE(this->Errors.find("Enter was not pressed"), std::string::npos) << this->Errors;
  EXPECT_EQ(this->Model.GetPresets(), 2) << "the user has not confirmed that the arm rests";
}

TEST_F(WoodenToolTest, AsksAgainWhereTheZeroIsNotTaken)
{
  this->Model.IgnoresPresets = true;
  EXPECT_EQ(this->Run({ "home", "wooden" }, "\n\n"), 1);
  EXPECT_NE(this->Out.find("did not accept the pose of its arm"), std::string::npos) << this->Out;
  EXPECT_GE(this->Model.GetPresets(), 2);
}
