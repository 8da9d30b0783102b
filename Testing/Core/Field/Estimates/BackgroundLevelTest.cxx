// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the estimate of the value at which the background of a volume ends. The synthetic volumes
 * are balls of known values in a background of 0, so the threshold must be between these two
 * values. Otsu's threshold of two values with equal noise is in the middle between them (IEEE
 * Transactions on Systems, Man, and Cybernetics 9, 1979).
 */

#include "Core/Field/Estimates/BackgroundLevel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace VolumeHaptics;

namespace
{
constexpr std::int64_t Width = 80;
constexpr std::int64_t Dimensions[3] = { Width, Width, Width };

struct Ball
{
  double Radius;
  double Rise;
};

/// Returns white noise, averaged along x `passes` times, so that neighbouring voxels are
/// correlated.
std::vector<double> MakeNoise(double sigma, int passes)
{
  std::mt19937_64 engine(3);
  std::normal_distribution<double> random;
  std::vector<double> noise(static_cast<std::size_t>(Width * Width * Width));
  std::generate(noise.begin(), noise.end(), [&] { return random(engine); });
  for (int pass = 0; pass < passes; ++pass)
  {
    const std::vector<double> before = noise;
    for (std::size_t i = 1; i + 1 < noise.size(); ++i)
    {
      noise[i] = 0.25 * (before[i - 1] + 2.0 * before[i] + before[i + 1]);
    }
  }
  double squares = 0.0;
  for (const double value : noise)
  {
    squares += value * value / static_cast<double>(noise.size());
  }
  for (double& value : noise)
  {
    value *= sigma / std::sqrt(squares);
  }
  return noise;
}

/// Returns a volume with concentric balls, blurred by a voxel, and noise.
std::vector<double> MakeBalls(const std::vector<Ball>& balls, double sigma, int passes = 0)
{
  std::vector<double> volume = MakeNoise(sigma, passes);
  for (std::size_t i = 0; i < volume.size(); ++i)
  {
    const auto number = static_cast<std::int64_t>(i);
    const double middle = 0.5 * (Width - 1);
    const double r = std::hypot(static_cast<double>(number % Width) - middle,
      static_cast<double>(number / Width % Width) - middle,
      static_cast<double>(number / Width / Width) - middle);
    for (const Ball& ball : balls)
    {
      volume[i] += ball.Rise * 0.5 * std::erfc((r - ball.Radius) / std::sqrt(2.0));
    }
  }
  return volume;
}

BackgroundLevel Find(const std::vector<double>& volume)
{
  return BackgroundLevel::Estimate(
    [&](std::int64_t i) { return volume[static_cast<std::size_t>(i)]; }, Dimensions);
}
} // namespace

TEST(BackgroundLevel, IsBetweenTwoMaterialsWhateverTheirNoise)
{
  for (const double sigma : { 0.0, 2.0, 10.0 })
  {
    for (const int passes : { 0, 24 })
    {
      SCOPED_TRACE(sigma + 1000.0 * passes);
      const BackgroundLevel level = Find(MakeBalls({ { 24.0, 100.0 } }, sigma, passes));
      ASSERT_TRUE(level.IsThere);
      EXPECT_NEAR(level.Threshold, 50.0, 12.0);
      EXPECT_GT(level.Full, level.Threshold);
      EXPECT_LT(level.Full, 65.0);
      EXPECT_NEAR(level.Dark, 0.0, 1.0);
      EXPECT_NEAR(level.Bright, 100.0, 5.0);
    }
  }
}

TEST(BackgroundLevel, IsThereWithFewLevelsAndClippedAir)
{
  std::vector<double> volume = MakeBalls({ { 24.0, 8.0 } }, 1.0, 4);
  for (double& value : volume)
  {
    value = std::round(std::clamp(value, 0.0, 32.0));
  }
  const BackgroundLevel level = Find(volume);
  ASSERT_TRUE(level.IsThere);
  EXPECT_NEAR(level.Threshold, 4.0, 1.0);
}

TEST(BackgroundLevel, LeavesNoDarkMaterialToTheBackground)
{
  // A metal marker causes most of the variance. The body around it must not count as background.
  const BackgroundLevel level = Find(MakeBalls({ { 32.0, 100.0 }, { 10.0, 900.0 } }, 5.0));
  ASSERT_TRUE(level.IsThere);
  EXPECT_NEAR(level.Threshold, 50.0, 5.0);
  EXPECT_LT(level.Full, 65.0);
}

TEST(BackgroundLevel, IsNotInOneHeap)
{
  EXPECT_FALSE(Find(MakeBalls({}, 5.0)).IsThere);
  EXPECT_FALSE(Find(MakeBalls({}, 5.0, 24)).IsThere);
  EXPECT_FALSE(Find(std::vector<double>(Width * Width * Width, 7.0)).IsThere);
  std::vector<double> clipped = MakeBalls({}, 5.0);
  for (double& value : clipped)
  {
    value = std::max(value, 0.0);
  }
  EXPECT_FALSE(Find(clipped).IsThere);
}

TEST(BackgroundLevel, OfPiecesIsThatOfTheWhole)
{
  std::vector<double> volume = MakeBalls({ { 24.0, 100.0 } }, 5.0, 8);
  volume[12345] = std::numeric_limits<double>::quiet_NaN();
  const BackgroundLevel whole = Find(volume);
  NoiseSamples samples;
  const int all[6] = { 0, Width - 1, 0, Width - 1, 0, Width - 1 };
  for (const auto& [first, last] : { std::pair(0, 30), std::pair(31, 79) })
  {
    const int part[6] = { 0, Width - 1, 0, Width - 1, first, last };
    NoiseSamples more;
    CollectNoiseSamples([&](std::int64_t i)
      { return volume[static_cast<std::size_t>(i + first * Width * Width)]; },
      part, all, more);
    if (samples.Indices.empty())
    {
      samples = more;
    }
    else
    {
      samples.Merge(more);
    }
  }
  const BackgroundLevel pieces = BackgroundLevel::Estimate(samples);
  ASSERT_TRUE(whole.IsThere);
  EXPECT_TRUE(pieces.IsThere);
  EXPECT_EQ(pieces.Threshold, whole.Threshold);
  EXPECT_EQ(pieces.Full, whole.Full);
  EXPECT_EQ(pieces.Dark, whole.Dark);
  EXPECT_EQ(pieces.Bright, whole.Bright);
}
