// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the roughness of synthetic forces: sines (root mean square a/sqrt(2)), steps, sawtooths.
 */

#include "Roughness.h"

#include "Shapes.h"

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
std::vector<double> MakeForce(int ticks, const std::function<double(double)>& ofTime)
{
  std::vector<double> force;
  for (int i = 0; i < ticks; ++i)
  {
    force.push_back(ofTime(0.001 * i));
  }
  return force;
}

TEST(Roughness, ASineIsInTheBandOfItsFrequencyAlone)
{
  const auto sine = [](double frequency)
  {
    return MeasureRoughness(
      MakeForce(1730, [&](double t) { return 2.0 + 0.1 * std::sin(TwoPi * frequency * t + 0.4); }));
  };
  const double fraction = 100.0 * 0.1 / std::sqrt(2.0) / 2.0;
  EXPECT_NEAR(sine(60.3).Low, fraction, 0.01 * fraction);
  EXPECT_LT(sine(60.3).High, 0.01 * fraction);
  EXPECT_NEAR(sine(217.7).High, fraction, 0.01 * fraction);
  EXPECT_NEAR(sine(60.3).Both, fraction, 0.01 * fraction);
  EXPECT_NEAR(sine(217.7).Both, fraction, 0.01 * fraction);
  EXPECT_LT(sine(217.7).Low, 0.01 * fraction);
  EXPECT_LT(sine(3.0).Low, 0.01 * fraction) << "a slow change is no roughness";
  EXPECT_LT(sine(3.0).High, 0.001 * fraction);
  EXPECT_NEAR(sine(3.0).Mean, 2.0, 0.02);
}

TEST(Roughness, FallsWithinFiveMillisecondsAreDrops)
{
  // Make four periods of a sawtooth that falls by a fraction within a time, then rises for a
  // quarter of a second.
  const auto saw = [](double fall, double time)
  {
    return MeasureRoughness(MakeForce(1000,
      [&](double t)
      {
        const double u = std::fmod(t, 0.25) - 0.1;
        const double down = std::clamp(u / time, 0.0, 1.0);
        const double up = std::clamp((u - 0.05) / 0.1, 0.0, 1.0);
        return 1.0 - fall * (down - up);
      }));
  };
  EXPECT_EQ(saw(0.5, 0.001).Drops, 4);
  EXPECT_EQ(saw(0.5, 0.004).Drops, 4);
  EXPECT_EQ(saw(0.5, 0.04).Drops, 0) << "too slow";
  EXPECT_EQ(saw(0.25, 0.001).Drops, 0) << "too small";
  EXPECT_EQ(saw(0.5, 0.001).Reversals, 4);
  EXPECT_EQ(saw(0.03, 0.001).Reversals, 0);
  EXPECT_NEAR(saw(0.5, 0.001).LargestStep, 0.5, 1e-9);
  EXPECT_NEAR(saw(0.5, 0.005).LargestStep, 0.1, 1e-9);
}

TEST(Roughness, TellsWhereDropsEnd)
{
  std::vector<double> force(400, 1.0);
  std::fill(force.begin() + 100, force.begin() + 150, 0.6);
  std::fill(force.begin() + 300, force.end(), 0.65);
  EXPECT_EQ(DetectDrops(force), (std::vector<std::size_t>{ 100, 300 }));
  EXPECT_TRUE(DetectDrops(std::vector<double>(100, 0.04)).empty());
}

TEST(Roughness, WithoutForceOrTooShortThereIsNone)
{
  EXPECT_EQ(MeasureRoughness({}).Duration, 0.0);
  EXPECT_EQ(MeasureRoughness(std::vector<double>(1000, 0.0)).Duration, 0.0);
  EXPECT_EQ(MeasureRoughness(std::vector<double>(50, 1.0)).Duration, 0.0);
}

TEST(Roughness, StrokesCountByTheirLength)
{
  Roughness shortOne{ 1.0, 2.0, 4.0, 1.0, 4.2, 3, 2, 0.5 };
  Roughness longOne{ 3.0, 1.0, 0.0, 1.0, 1.0, 1, 0, 0.1 };
  const Roughness all = Average({ shortOne, longOne, {} });
  EXPECT_DOUBLE_EQ(all.Duration, 4.0);
  EXPECT_DOUBLE_EQ(all.Mean, 1.25);
  EXPECT_DOUBLE_EQ(all.Low, 1.0);
  EXPECT_DOUBLE_EQ(all.High, 1.0);
  EXPECT_DOUBLE_EQ(all.Both, 1.8);
  EXPECT_EQ(all.Drops, 4);
  EXPECT_EQ(all.Reversals, 2);
  EXPECT_DOUBLE_EQ(all.LargestStep, 0.5);
}
} // namespace
