// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the commands of all joints are reduced by the same factor.
 */

#include "SafetyRig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace servotest;

TEST(SaturateTogether, KeepsTheDirectionAndTheSigns)
{
  std::mt19937_64 engine(11);
  for (int i = 0; i < 2000; ++i)
  {
    std::array<double, 3> commands;
    for (double& c : commands)
    {
      c = static_cast<double>(engine() % 20001) / 10.0 - 1000.0;
    }
    std::array<double, 3> out = commands;
    const double limit = static_cast<double>(engine() % 1000);
    SaturateTogether(out.data(), 3, limit);
    const double largest =
      std::max({ std::abs(commands[0]), std::abs(commands[1]), std::abs(commands[2]) });
    const double scale = largest > limit ? limit / largest : 1.0;
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(out[c], scale * commands[c], 1e-9);
      EXPECT_GE(out[c] * commands[c], 0.0);
      EXPECT_LE(std::abs(out[c]), limit + 1e-9);
    }
  }
}

TEST(SaturateTogether, SendsNothingForWhatIsNotANumber)
{
  for (const double bad : { NaN, Infinity, -Infinity })
  {
    std::array<double, 3> commands{ 1.0, bad, -2.0 };
    SaturateTogether(commands.data(), 3, 5.0);
    EXPECT_EQ(commands, (std::array<double, 3>{}));
  }
  std::array<double, 2> commands{ 1.0, -2.0 };
  SaturateTogether(commands.data(), 2, -1.0);
  EXPECT_EQ(commands, (std::array<double, 2>{})) << "a limit below zero must not turn a sign";
}
