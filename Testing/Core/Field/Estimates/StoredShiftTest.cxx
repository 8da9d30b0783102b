// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the estimate of the shift with which Hounsfield units are stored, on synthetic bodies. Air
 * is at -1000 and water at 0 by the definition of the unit (Hounsfield, British Journal of
 * Radiology 46, 1973). Fat, muscle, lung and bone have textbook values (Bushberg, The Essential
 * Physics of Medical Imaging, table 10-1). The test adds a known offset: 1024 is the usual Rescale
 * Intercept of DICOM (PS3.3 C.11.1); 1000 and 32768 also occur.
 */

#include "Core/Field/Estimates/StoredShift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace VolumeHaptics;

namespace
{
constexpr std::int64_t Width = 72;
constexpr std::int64_t Dimensions[3] = { Width, Width, Width };

/// Makes a body of muscle under fat, with bone, surrounded by air. A chest also has lungs.
std::vector<double> MakeBody(double sigma, bool hasLungs)
{
  std::mt19937_64 engine(5);
  std::normal_distribution<double> noise(0.0, sigma);
  std::vector<double> volume(static_cast<std::size_t>(Width * Width * Width));
  for (std::size_t i = 0; i < volume.size(); ++i)
  {
    const auto n = static_cast<std::int64_t>(i);
    const double x = static_cast<double>(n % Width) - 0.5 * Width;
    const double y = static_cast<double>(n / Width % Width) - 0.5 * Width;
    const double z = static_cast<double>(n / Width / Width) - 0.5 * Width;
    const double r = std::hypot(x, y);
    const bool isLung = hasLungs && std::hypot(std::abs(x) - 12.0, y) < 8.0 && std::abs(z) < 25.0;
    const double value = r > 30.0     ? -1000.0
      : r > 27.0                      ? -100.0
      : std::hypot(x, y - 20.0) < 4.0 ? 900.0
      : isLung                        ? -850.0
                                      : 50.0;
    volume[i] = std::round(value + (sigma > 0.0 ? noise(engine) : 0.0));
  }
  return volume;
}

StoredShift Find(const std::vector<double>& volume)
{
  return StoredShift::Estimate(
    [&](std::int64_t i) { return volume[static_cast<std::size_t>(i)]; }, Dimensions);
}

} // namespace

TEST(StoredShift, IsWhatWasAddedToACT)
{
  for (const bool hasLungs : { false, true })
  {
    for (const double sigma : { 2.0, 10.0, 20.0 })
    {
      const std::vector<double> body = MakeBody(sigma, hasLungs);
      EXPECT_EQ(Find(body).Shift, 0.0);
      EXPECT_FALSE(Find(body).IsStrange);
      for (const double added : { 1024.0, 1000.0, 32768.0 })
      {
        std::vector<double> stored = body;
        std::transform(stored.begin(), stored.end(), stored.begin(),
          [added](double value) { return std::max(0.0, value + added); });
        const StoredShift found = Find(stored);
        EXPECT_EQ(found.Shift, -added) << "noise of " << sigma << " HU";
        // The estimated value of air must be right within 12 HU, so that no other offset is nearer.
        EXPECT_NEAR(found.Air, added - 1000.0, 12.0);
        EXPECT_FALSE(found.IsStrange);
      }
    }
  }
}

TEST(StoredShift, IsNotMovedByPadding)
{
  for (const double padding : { 0.0, -2000.0 })
  {
    std::vector<double> stored = MakeBody(15.0, true);
    for (std::size_t i = 0; i < stored.size(); ++i)
    {
      const auto n = static_cast<std::int64_t>(i);
      const bool isPadded = std::hypot(static_cast<double>(n % Width) - 0.5 * Width,
                              static_cast<double>(n / Width % Width) - 0.5 * Width) > 34.0;
      stored[i] = isPadded ? padding : std::max(0.0, stored[i] + 1024.0);
    }
    EXPECT_EQ(Find(stored).Shift, -1024.0) << "padding of " << padding;
  }
}

TEST(StoredShift, IsNotSeenInOtherData)
{
  // A masked head, outside of which the values are 0, which is not the value of air.
  std::vector<double> masked = MakeBody(10.0, false);
  std::transform(masked.begin(), masked.end(), masked.begin(),
    [](double value) { return value < -500.0 ? 0.0 : value; });
  EXPECT_EQ(Find(masked).Shift, 0.0);
  EXPECT_FALSE(Find(masked).IsStrange);

  // Bone in water, with values in Hounsfield units, with and without noise.
  for (const double sigma : { 0.0, 10.0 })
  {
    std::vector<double> bone = MakeBody(sigma, false);
    std::transform(bone.begin(), bone.end(), bone.begin(),
      [](double value) { return value < -500.0 ? value + 1000.0 : 1000.0; });
    EXPECT_EQ(Find(bone).Shift, 0.0) << "noise of " << sigma << " HU";
    EXPECT_FALSE(Find(bone).IsStrange);
  }

  // Magnitudes of magnetic resonance imaging: a dark background and a single peak.
  std::vector<double> magnitudes = MakeBody(10.0, false);
  std::transform(magnitudes.begin(), magnitudes.end(), magnitudes.begin(),
    [](double value) { return value < -500.0 ? 8.0 : 300.0 + value; });
  EXPECT_EQ(Find(magnitudes).Shift, 0.0);
}

TEST(StoredShift, TellsWhatCannotBeHounsfieldUnits)
{
  const std::vector<double> body = MakeBody(10.0, false);
  const auto isStrange = [&](double shift, double scale)
  {
    std::vector<double> stored = body;
    std::transform(stored.begin(), stored.end(), stored.begin(),
      [=](double value) { return (value + shift) * scale; });
    const StoredShift found = Find(stored);
    EXPECT_EQ(found.Shift, 0.0);
    return found.IsStrange;
  };
  EXPECT_TRUE(isStrange(1000.0, 0.0005)); // attenuation
  EXPECT_TRUE(isStrange(1100.0, 25.0));   // grey values of 16 bits
  EXPECT_TRUE(isStrange(3000.0, 1.0));    // no value is that of air or tissue
  EXPECT_FALSE(isStrange(0.0, 1.0));
}

TEST(StoredShift, OfPiecesIsThatOfTheWhole)
{
  std::vector<double> stored = MakeBody(20.0, true);
  std::transform(stored.begin(), stored.end(), stored.begin(),
    [](double value) { return std::max(0.0, value + 1024.0); });
  const int whole[6] = { 0, Width - 1, 0, Width - 1, 0, Width - 1 };
  NoiseSamples samples;
  for (int part = 0; part < 2; ++part)
  {
    const int half = Width / 2;
    const int extent[6] = { 0, Width - 1, 0, Width - 1, part * half, part * half + half - 1 };
    const std::int64_t first = std::int64_t{ part } * half * Width * Width;
    NoiseSamples piece;
    CollectNoiseSamples([&](std::int64_t i) { return stored[static_cast<std::size_t>(first + i)]; },
      extent, whole, piece);
    part == 0 ? void(samples = piece) : samples.Merge(piece);
  }
  const StoredShift pieces = StoredShift::Estimate(samples);
  EXPECT_EQ(pieces.Shift, -1024.0);
  EXPECT_EQ(pieces.Air, Find(stored).Air);
}
