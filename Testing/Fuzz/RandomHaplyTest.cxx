// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target for Haply's Inverse service on random bytes.
 */

#include "TouchHaply.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

TEST(Fuzz, RandomBytesComeFromAnInverseService)
{
  constexpr int services = 300;
  for (int seed = 0; seed < services; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(500 + random() % 2000);
    for (std::uint8_t& byte : bytes)
    {
      byte = static_cast<std::uint8_t>(random());
    }
    TouchHaply(bytes.data(), bytes.size());
  }
}
