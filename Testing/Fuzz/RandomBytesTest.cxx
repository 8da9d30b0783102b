// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target on random bytes, for compilers without libFuzzer and for the sanitizer
 * runs.
 */

#include "TouchAnything.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

TEST(Fuzz, RandomBytesAreTouched)
{
  constexpr int scenes = 300;
  for (int seed = 0; seed < scenes; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(500 + random() % 4000);
    for (std::uint8_t& byte : bytes)
    {
      byte = static_cast<std::uint8_t>(random());
    }
    TouchAnything(bytes.data(), bytes.size());
  }
}
