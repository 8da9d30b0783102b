// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testbed.h"

#include <gtest/gtest.h>

#include <iostream>

#include <sys/prctl.h>

namespace emulated
{
UMockdevTestbed* Testbed()
{
  static UMockdevTestbed* const testbed = umockdev_testbed_new();
  return testbed;
}
} // namespace emulated

int main(int argc, char** argv)
{
  // Asked before there is a testbed, umockdev remembers that there is none.
  emulated::Testbed();
  if (!umockdev_in_mock_environment())
  {
    std::cerr << "Skipped: umockdev can't take the kernel's place here. Start this with "
                 "umockdev-wrapper.\n";
    return 77;
  }
  // umockdev sleeps for no time after every call, which takes as long as the kernel's timer slack.
  prctl(PR_SET_TIMERSLACK, 1UL);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
