// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testbed.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <sys/prctl.h>

namespace emulated
{
UMockdevTestbed* Testbed()
{
  static UMockdevTestbed* const testbed = umockdev_testbed_new();
  return testbed;
}

void RememberConfirmed(const std::string& identity)
{
  std::ofstream(std::getenv("VOLUMEHAPTICS_DEVICES"), std::ios::app)
    << identity << " confirmed=2026-11-01\n";
}
} // namespace emulated

namespace
{
/**
 * Removes umockdev's folder. Deleting the testbed would also do this, but threads may use the
 * testbed until the program ends.
 */
void RemoveTestbed()
{
  char* const root = umockdev_testbed_get_root_dir(emulated::Testbed());
  std::error_code ignored;
  std::filesystem::remove_all(root, ignored);
  g_free(root);
}
} // namespace

int main(int argc, char** argv)
{
  // Create the testbed first. Otherwise, umockdev would cache that there is none.
  emulated::Testbed();
  testing::InitGoogleTest(&argc, argv);
  if (!testing::GTEST_FLAG(list_tests) && !umockdev_in_mock_environment())
  {
    std::cerr << "Skipped: umockdev can't take the kernel's place here. Start this with "
                 "umockdev-wrapper.\n";
    RemoveTestbed();
    return 77;
  }
  char* const root = umockdev_testbed_get_root_dir(emulated::Testbed());
  setenv("VOLUMEHAPTICS_DEVICES", (std::string(root) + "/devices.txt").c_str(), 1);
  g_free(root);
  // umockdev sleeps for zero seconds after every call, which takes as long as the timer slack, so
  // set the smallest slack.
  prctl(PR_SET_TIMERSLACK, 1UL);
  const int result = RUN_ALL_TESTS();
  RemoveTestbed();
  return result;
}
