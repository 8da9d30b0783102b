// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the fractions in bricks with a table of all samples.
 */

#include "Core/Carving/CarvedBricks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

using namespace VolumeHaptics;

namespace
{
using SampleIndex = std::tuple<std::int64_t, std::int64_t, std::int64_t>;

void PutTissue(CarvedBricks& bricks, const SampleIndex& index, std::uint8_t fraction)
{
  const auto [i, j, k] = index;
  const std::uint32_t brick = bricks.FindOrAdd(CarvedBricks::KeyOf({ i / 8, j / 8, k / 8 }));
  ASSERT_NE(brick, CarvedBricks::None);
  const auto row = static_cast<int>(j % 8 + 8 * (k % 8));
  const auto shift = static_cast<int>(8 * (i % 8));
  std::uint64_t fractions = bricks.GetRow(brick, row);
  fractions &= ~(std::uint64_t{ 255 } << shift);
  bricks.SetRow(brick, row, fractions | std::uint64_t{ fraction } << shift);
  bricks.MarkChanged(brick);
}
} // namespace

TEST(CarvedBricks, KeepShares)
{
  CarvedBricks bricks(1500);
  EXPECT_TRUE(bricks.IsEmpty());
  std::map<SampleIndex, std::uint8_t> expected;
  std::mt19937_64 engine(3);
  // Use indices near the beginning of a volume of 2048^3 samples, and in its farthest bricks.
  const auto random = [&engine]()
  {
    const auto along = [&engine]()
    { return static_cast<std::int64_t>(engine() % 40 + (engine() % 2) * 2000); };
    const std::int64_t i = along();
    const std::int64_t j = along();
    return SampleIndex{ i, j, along() };
  };
  for (int n = 0; n < 20000; ++n)
  {
    const SampleIndex index = random();
    const auto fraction = static_cast<std::uint8_t>(engine());
    expected[index] = fraction;
    PutTissue(bricks, index, fraction);
  }
  for (int n = 0; n < 20000; ++n)
  {
    expected.emplace(random(), CarvedBricks::Whole);
  }
  for (const auto& [index, fraction] : expected)
  {
    const auto [i, j, k] = index;
    ASSERT_EQ(bricks.GetFraction(i, j, k), fraction);
  }
  EXPECT_EQ(bricks.GetFraction(16000000, 3, 2047), CarvedBricks::Whole);
  for (int n = 0; n < 2000; ++n)
  {
    const auto [i, j, k] = random();
    const std::int64_t low[3] = { i, j, k };
    const std::int64_t high[3] = { i + static_cast<std::int64_t>(engine() % 20),
      j + static_cast<std::int64_t>(engine() % 3), k + static_cast<std::int64_t>(engine() % 9) };
    bool has = false;
    for (std::uint32_t brick = 0; brick < bricks.GetCount(); ++brick)
    {
      const BrickPlace at = CarvedBricks::PlaceOf(bricks.GetKey(brick));
      const auto meets = [](std::int64_t first, std::int64_t last, std::int64_t place)
      { return last >= 8 * place && first < 8 * place + 8; };
      has = has ||
        (meets(low[0], high[0], at.X) && meets(low[1], high[1], at.Y) &&
          meets(low[2], high[2], at.Z));
    }
    ASSERT_EQ(bricks.HasBricks(low, high), has);
  }
}

TEST(CarvedBricks, HaveRoomForSoManyAndNotForMore)
{
  CarvedBricks bricks(100);
  for (std::int64_t x = 0; x < 100; ++x)
  {
    EXPECT_EQ(bricks.FindOrAdd(CarvedBricks::KeyOf({ x, 7 * x, 0 })), x);
  }
  EXPECT_EQ(bricks.FindOrAdd(CarvedBricks::KeyOf({ 0, 0, 1 })), CarvedBricks::None);
  EXPECT_EQ(bricks.FindOrAdd(CarvedBricks::KeyOf({ 42, 294, 0 })), 42u) << "those it has it finds";
  EXPECT_EQ(bricks.Find(CarvedBricks::KeyOf({ 0, 0, 1 })), CarvedBricks::None);
  EXPECT_EQ(bricks.GetCount(), 100u);
}

TEST(CarvedBricks, NeedNoMemoryThatGrowsWithTheVolume)
{
  const CarvedBricks bricks;
  EXPECT_LE(bricks.GetMemorySize(), 9u << 20);
}

TEST(CarvedBricks, TellEachChangeOnce)
{
  CarvedBricks bricks(300);
  const int follower = bricks.AddFollower();
  std::set<std::uint32_t> changed;
  const auto take = [&]()
  {
    std::set<std::uint32_t> taken;
    bricks.DrainChanged(
      follower, [&](std::uint32_t brick) { EXPECT_TRUE(taken.insert(brick).second); });
    return taken;
  };
  EXPECT_TRUE(take().empty());
  std::mt19937_64 engine(4);
  for (int round = 0; round < 50; ++round)
  {
    std::set<std::uint32_t> expected;
    for (std::uint64_t n = engine() % 40; n > 0; --n)
    {
      const std::uint32_t brick = bricks.FindOrAdd(engine() % 300);
      bricks.MarkChanged(brick);
      expected.insert(brick);
    }
    EXPECT_EQ(take(), expected);
  }
}

TEST(CarvedBricks, TellEachFollowerByItself)
{
  CarvedBricks bricks(300);
  const auto take = [&](int follower)
  {
    std::set<std::uint32_t> taken;
    bricks.DrainChanged(follower, [&](std::uint32_t brick) { taken.insert(brick); });
    return taken;
  };
  const auto change = [&](std::uint64_t key) { bricks.MarkChanged(bricks.FindOrAdd(key)); };
  const int first = bricks.AddFollower();
  change(7);
  change(8);
  const int second = bricks.AddFollower();
  ASSERT_NE(first, second);
  const std::set<std::uint32_t> both{ 0, 1 };
  EXPECT_EQ(take(second), both) << "that were changed before it came";
  EXPECT_EQ(take(first), both);
  const std::uint64_t changes = bricks.GetChanges();
  change(8);
  EXPECT_NE(bricks.GetChanges(), changes);
  EXPECT_EQ(take(first), std::set<std::uint32_t>{ 1 });
  EXPECT_TRUE(take(first).empty());
  EXPECT_EQ(take(second), std::set<std::uint32_t>{ 1 });
  bricks.RemoveFollower(first);
  for (int i = 1; i < CarvedBricks::MostFollowers; ++i)
  {
    EXPECT_EQ(bricks.AddFollower(CarvedBricks::MostFollowers - i), -1) << "they are kept free";
    EXPECT_GE(bricks.AddFollower(), 0);
  }
  EXPECT_EQ(bricks.AddFollower(), -1);
}
