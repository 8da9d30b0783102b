// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target for the Falcon on random bytes.
 */

#include "TouchFalcon.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

TEST(Fuzz, RandomBytesComeFromAFalcon)
{
  constexpr int devices = 1000;
  for (int seed = 0; seed < devices; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(500 + random() % 4000);
    for (std::uint8_t& byte : bytes)
    {
      byte = static_cast<std::uint8_t>(random());
    }
    TouchFalcon(bytes.data(), bytes.size());
  }
}
