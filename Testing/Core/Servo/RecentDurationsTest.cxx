// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the statistics of the latest durations with those of a sorted list.
 */

#include "Core/Servo/RecentDurations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

using VolumeHaptics::RecentDurations;

namespace
{
struct Figures
{
  std::int64_t Upper = 0;
  std::int64_t Typical = 0;
};

/// Computes the expected statistics by sorting: from at most the last 256 durations, and only those
/// within the last second.
Figures Sort(const std::vector<std::int64_t>& all)
{
  std::vector<std::int64_t> last;
  std::int64_t sum = 0;
  for (auto d = all.rbegin(); d != all.rend() && last.size() < 256 && sum < 1000000000; ++d)
  {
    last.push_back(*d);
    sum += *d;
  }
  std::sort(last.begin(), last.end());
  const auto at = [&](double share) {
    return last[static_cast<std::size_t>(std::ceil(share * static_cast<double>(last.size()))) - 1];
  };
  return { at(0.95), at(0.5) };
}
} // namespace

TEST(RecentDurations, AreNotKnownBeforeTheFirstSixteen)
{
  RecentDurations durations;
  for (int i = 0; i < 15; ++i)
  {
    durations.Add(1000000);
    EXPECT_EQ(durations.GetUpper(), 0);
  }
  durations.Add(1000000);
  EXPECT_EQ(durations.GetUpper(), 1000000);
  EXPECT_EQ(durations.GetTypical(), 1000000);
  durations.Reset();
  EXPECT_EQ(durations.GetUpper(), 0);
  EXPECT_EQ(durations.GetTypical(), 0);
}

TEST(RecentDurations, AreThoseThatSortingGives)
{
  std::mt19937_64 engine(3);
  for (const double scale : { 1e5, 1e6, 8e6, 1e8, 3e9 })
  {
    RecentDurations durations;
    std::vector<std::int64_t> all;
    for (int i = 1; i <= 2000; ++i)
    {
      const double u = static_cast<double>(engine() >> 11) * 0x1p-53;
      all.push_back(static_cast<std::int64_t>(scale * (0.5 + u + (u > 0.97 ? 20.0 : 0.0))));
      durations.Add(all.back());
      if (i % 16 == 0)
      {
        const Figures figures = Sort(all);
        ASSERT_EQ(durations.GetUpper(), figures.Upper) << scale << ", " << i;
        ASSERT_EQ(durations.GetTypical(), figures.Typical) << scale << ", " << i;
      }
    }
  }
}

TEST(RecentDurations, AFewLateOnesDoNotCountAndALastingChangeDoes)
{
  RecentDurations durations;
  for (int i = 0; i < 1000; ++i)
  {
    durations.Add(i % 25 == 0 ? 9000000 : 1000000);
  }
  EXPECT_EQ(durations.GetUpper(), 1000000);
  for (int i = 0; i < 128; ++i)
  {
    durations.Add(8000000);
  }
  EXPECT_EQ(durations.GetUpper(), 8000000) << "a second later";
  EXPECT_EQ(durations.GetTypical(), 8000000);
}

TEST(RecentDurations, AreReadWhileTheyAreWritten)
{
  RecentDurations durations;
  std::atomic<bool> ends{ false };
  std::thread writer(
    [&]
    {
      for (int i = 0; i < 200000; ++i)
      {
        durations.Add(i % 2 == 0 ? 1000000 : 2000000);
      }
      ends = true;
    });
  while (!ends)
  {
    const std::int64_t upper = durations.GetUpper();
    ASSERT_TRUE(upper == 0 || upper == 2000000) << upper;
  }
  writer.join();
}
