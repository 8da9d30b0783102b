// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

int main(int argc, char** argv)
{
  // Leave out tests that can't run on this kernel. The kernel drops reports that are shorter than
  // their descriptor says, before programs see them. And its virtual hub has only one bus for
  // devices of this speed.
  GTEST_FLAG_SET(
    filter, "-*.ShortReport:SpaceMouse.AReportOfAnotherModel*:FalconListing.InTheOrderOfThePorts");
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
