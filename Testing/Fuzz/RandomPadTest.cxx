// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target for gamepads on random bytes.
 */

#include "TouchPad.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

TEST(Fuzz, RandomBytesComeFromAGamepad)
{
  for (int seed = 0; seed < 8000; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(20 + random() % 600);
    for (std::uint8_t& byte : bytes)
    {
      byte = static_cast<std::uint8_t>(random());
    }
    bytes[0] = static_cast<std::uint8_t>(seed);
    TouchPad(bytes.data(), bytes.size());
  }
}
