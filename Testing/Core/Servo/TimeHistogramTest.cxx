// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that percentiles from fixed buckets are right within 1/8.
 */

#include "Core/Servo/TimeHistogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using VolumeHaptics::TimeHistogram;

TEST(TimeHistogram, IsZeroWhenEmpty)
{
  TimeHistogram histogram;
  EXPECT_EQ(histogram.GetTotal(), 0U);
  EXPECT_EQ(histogram.GetPercentile(0.5), 0.0);
}

TEST(TimeHistogram, StandsForADurationToAnEighth)
{
  for (double duration = 1.0; duration < 3.6e12; duration *= 1.0137)
  {
    TimeHistogram histogram;
    const auto ns = static_cast<std::int64_t>(duration);
    histogram.Add(ns);
    const double found = histogram.GetPercentile(0.5);
    EXPECT_GT(found, ns);
    EXPECT_LE(found, std::max(ns + 1.0, 1.125 * (ns + 1.0))) << ns;
  }
}

TEST(TimeHistogram, BucketsFollowOneAnother)
{
  double last = 0.0;
  for (std::int64_t ns = 0; ns < 100000; ++ns)
  {
    TimeHistogram histogram;
    histogram.Add(ns);
    const double edge = histogram.GetPercentile(1.0);
    ASSERT_GE(edge, last) << ns;
    last = edge;
  }
}

TEST(TimeHistogram, FindsThePercentilesOfASample)
{
  TimeHistogram histogram;
  std::mt19937_64 engine(7);
  std::vector<std::int64_t> sample;
  for (int i = 0; i < 20000; ++i)
  {
    const double u = static_cast<double>(engine() >> 11) * 0x1p-53;
    sample.push_back(static_cast<std::int64_t>(100.0 * std::exp(9.0 * u)));
    histogram.Add(sample.back());
  }
  std::sort(sample.begin(), sample.end());
  EXPECT_EQ(histogram.GetTotal(), sample.size());
  for (const double share : { 0.001, 0.1, 0.5, 0.9, 0.99, 0.999 })
  {
    const auto rank = static_cast<std::size_t>(std::ceil(share * 20000.0)) - 1;
    const double exact = static_cast<double>(sample[rank]);
    EXPECT_GT(histogram.GetPercentile(share), exact);
    EXPECT_LE(histogram.GetPercentile(share), 1.125 * exact + 1.0);
  }
}

TEST(TimeHistogram, TakesFractionsBeyondTheEndsForTheEnds)
{
  TimeHistogram histogram;
  histogram.Add(10);
  histogram.Add(1000);
  EXPECT_EQ(histogram.GetPercentile(-3.0), histogram.GetPercentile(0.0));
  EXPECT_EQ(histogram.GetPercentile(7.0), histogram.GetPercentile(1.0));
  EXPECT_EQ(histogram.GetPercentile(0.0), 11.0);
  EXPECT_EQ(histogram.GetPercentile(0.5), 11.0);
  EXPECT_GT(histogram.GetPercentile(0.51), 1000.0);
}

TEST(TimeHistogram, TakesExtremes)
{
  TimeHistogram histogram;
  histogram.Add(-5);
  histogram.Add(0);
  histogram.Add(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(histogram.GetPercentile(1.0), 1.0);
  histogram.Add(std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(histogram.GetTotal(), 4U);
  EXPECT_GT(histogram.GetPercentile(1.0), 3.6e12) << "more than an hour";
}

TEST(TimeHistogram, ForgetsOnReset)
{
  TimeHistogram histogram;
  histogram.Add(1000000);
  histogram.Reset();
  EXPECT_EQ(histogram.GetTotal(), 0U);
  EXPECT_EQ(histogram.GetPercentile(0.99), 0.0);
  histogram.Add(7);
  EXPECT_EQ(histogram.GetPercentile(0.99), 8.0);
}
