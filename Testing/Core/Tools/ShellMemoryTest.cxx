// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A tick of a shell never allocates, whatever it meets.
 */

#include "Rigs/AllocationCounter.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

TEST(ShellMemoryUse, NoTickAllocates)
{
  TestVolume volume(ScalarType::Float32, { 24, 24, 24 });
  std::mt19937_64 engine(3);
  volume.Fill<float>(
    [&](std::int64_t, std::int64_t, std::int64_t k)
    {
      const auto dice = engine() % 1000;
      return dice == 0 ? std::numeric_limits<float>::quiet_NaN() : 70.0F * k + 0.1F * dice;
    });
  HapticModelDescription scene = Describe(volume);
  ShellSettings settings;
  settings.Level = 800.0;
  ShellHand hand(scene, MakeSphere(3.0, 400), settings);
  Wanderer wanderer(24.0);
  double most = 0.0;
  const std::size_t before = CountAllocations().Calls;
  for (int i = 0; i < 3000; ++i)
  {
    ShellPose pose{ wanderer.Next(), TurnAbout({ 1.0, 0.4, 0.2 }, 0.002 * i) };
    pose.Position.X = i % 997 == 0 ? std::numeric_limits<double>::quiet_NaN() : pose.Position.X;
    most = std::max(most, Norm(hand.TickAt(pose).Force));
  }
  EXPECT_EQ(CountAllocations().Calls, before);
  EXPECT_GT(most, 0.01);
}
