// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that ticks of a burr never allocate memory, however much they remove and restore.
 */

#include "Rigs/AllocationCounter.h"
#include "Rigs/BurrRig.h"

#include <gtest/gtest.h>

using namespace coretest;

TEST(BurrMemoryUse, NoTickAllocates)
{
  TestVolume volume(ScalarType::Int16, { 24, 24, 24 });
  std::mt19937_64 engine(3);
  volume.Fill<std::int16_t>([&](std::int64_t, std::int64_t, std::int64_t k)
    { return static_cast<std::int16_t>(70 * k + engine() % 100); });
  HapticModelDescription scene = Describe(volume);
  scene.Removal = std::make_shared<TissueRemoval>(20, 30);
  BurrInHand settings = MakeBurr(2e8, 800.0);
  settings.Vibration = 0.1;
  BurrInVolume hand(scene, settings, ConstantPolyline(0.05), 400);
  Wanderer wanderer(24.0);
  const std::size_t before = CountAllocations().Calls;
  for (int i = 0; i < 4000; ++i)
  {
    hand.IsSpinning = i % 300 < 250;
    if (i % 500 == 499)
    {
      scene.Removal->Request(static_cast<RemovalRequest>(1 + i / 500 % 3));
    }
    Vector3 at = 1000.0 * wanderer.Next();
    at.X = i % 997 == 0 ? std::numeric_limits<double>::quiet_NaN() : at.X;
    hand.Tick(at);
  }
  EXPECT_EQ(CountAllocations().Calls, before);
  EXPECT_GT(hand.Removed, 0.1);
}
