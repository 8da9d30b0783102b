// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the estimated noise of volumes of various sizes with the known standard deviation. Each
 * sample's noise is distributed uniformly over the whole numbers -a ... a, whose variance is a (a +
 * 1) / 3.
 */

#include "Core/Field/Estimates/NoiseEstimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace VolumeHaptics;

namespace
{
constexpr std::int64_t Amplitude = 34;
const double Sigma = std::sqrt(Amplitude * (Amplitude + 1) / 3.0);
constexpr double Padding = -2000.0;

/// A volume whose samples are computed and not stored: a smooth hill, padding in a fifth of the
/// volume, and noise.
struct Computed
{
  std::int64_t Size[3];
  std::int64_t Reads = 0;

  double Sample(std::int64_t number)
  {
    ++this->Reads;
    const std::int64_t at[3] = { number % this->Size[0], number / this->Size[0] % this->Size[1],
      number / this->Size[0] / this->Size[1] };
    if (5 * at[0] < this->Size[0])
    {
      return Padding;
    }
    double hill = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      hill += std::sin(3.0 * static_cast<double>(at[a]) / static_cast<double>(this->Size[a]));
    }
    // The finalizer of splitmix64 (public domain) maps a sample's number to a random number.
    auto bits = static_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15ULL;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
    bits ^= bits >> 31;
    return std::floor(500.0 * hill) - static_cast<double>(Amplitude) +
      static_cast<double>(bits % (2 * Amplitude + 1));
  }
  NoiseSamples Collect(std::int64_t firstSlice, std::int64_t lastSlice)
  {
    const int whole[6] = { 0, static_cast<int>(this->Size[0] - 1), 0,
      static_cast<int>(this->Size[1] - 1), 0, static_cast<int>(this->Size[2] - 1) };
    int part[6];
    std::copy(whole, whole + 6, part);
    part[4] = static_cast<int>(firstSlice);
    part[5] = static_cast<int>(lastSlice);
    const std::int64_t first = firstSlice * this->Size[0] * this->Size[1];
    NoiseSamples samples;
    CollectNoiseSamples(
      [this, first](std::int64_t i) { return this->Sample(first + i); }, part, whole, samples);
    return samples;
  }
};
} // namespace

TEST(NoiseEstimate, OfAnySizeIsTheNoiseThatIsThere)
{
  for (const std::int64_t n : { 64, 256, 406, 407, 1024, 2048, 3000 })
  {
    Computed volume{ { n, n, n } };
    NoiseSamples samples = volume.Collect(0, n - 1);
    if (HasRangeOfAll(volume.Size))
    {
      const double range[2] = { Padding, 1500.0 + Amplitude };
      samples.MergeRange(range);
    }
    EXPECT_NEAR(EstimateNoise(samples), Sigma, 0.05 * Sigma) << n << "^3";
    EXPECT_EQ(FindBorderValue(samples), Padding);
  }
}

TEST(NoiseEstimate, BlockByBlockIsTheSameToTheBit)
{
  for (const std::int64_t n : { 4, 5, 64, 203, 204, 406, 407, 1024 })
  {
    Computed volume{ { n, n + 1, n } };
    NoiseSamples samples = volume.Collect(0, n - 1);
    // One sample of one block is missing (NaN).
    const std::int64_t hole = n / 2 + n * (n / 2 + (n + 1) * (n / 2));
    const auto read = [&](std::int64_t number)
    { return number == hole ? std::nan("") : volume.Sample(number); };
    for (std::size_t s = 0; s < samples.Indices.size(); ++s)
    {
      samples.Values[s] = read(samples.Indices[s]);
    }
    double range[2] = { 1.0, 0.0 };
    if (HasRangeOfAll(volume.Size))
    {
      range[0] = Padding;
      range[1] = 1500.0 + Amplitude;
      samples.MergeRange(range);
    }
    volume.Reads = 0;
    EXPECT_EQ(EstimateNoise(read, volume.Size, range), EstimateNoise(samples)) << n;
    EXPECT_EQ(range[0], samples.Range[0]) << n;
    EXPECT_EQ(range[1], samples.Range[1]) << n;
    EXPECT_LE(volume.Reads, 17 * 17 * 17 * 125 + 8) << n;
  }
  double range[2] = { 1.0, 0.0 };
  const std::int64_t nothing[3] = { 0, 0, 0 };
  EXPECT_EQ(EstimateNoise([](std::int64_t) { return 1.0; }, nothing, range), 0.0);
}

TEST(NoiseEstimate, OfALargerVolumeLooksForPaddingAmongItsOwnSamples)
{
  // The padding is not the smallest value of this volume: a single smaller sample is outside all
  // blocks.
  for (const std::int64_t n : { 203, 204 })
  {
    Computed volume{ { n, n, n } };
    const std::int64_t lone = n * n * n / 2 + n - 2;
    const auto read = [&](std::int64_t number)
    { return number == lone ? Padding - 1.0 : volume.Sample(number); };
    double range[2] = { Padding - 1.0, 1500.0 + Amplitude };
    const double noise = EstimateNoise(read, volume.Size, range);
    const bool isOfAll = HasRangeOfAll(volume.Size);
    EXPECT_EQ(isOfAll, n == 203);
    EXPECT_NEAR(noise, isOfAll ? 0.0 : Sigma, 0.05 * Sigma) << n << "^3";
    EXPECT_EQ(range[0], isOfAll ? Padding - 1.0 : Padding);
  }
}

TEST(NoiseEstimate, OfALargeVolumeTakesNoMoreReadsThanOfAnother)
{
  EXPECT_FALSE(IsLargeVolume(Computed{ { 1024, 256, 256 } }.Size));
  EXPECT_TRUE(IsLargeVolume(Computed{ { 1024, 256, 257 } }.Size));
  EXPECT_TRUE(IsLargeVolume(Computed{ { 2147483647, 2147483647, 2147483647 } }.Size));
  EXPECT_FALSE(IsLargeVolume(Computed{ { 0, 5, 5 } }.Size));
  for (const std::int64_t n : { 407, 1024, 2048, 4096, 10000 })
  {
    Computed volume{ { n, n, n } };
    volume.Collect(0, n - 1);
    // The estimate reads eight blocks of 5^3 samples along each axis (nine if the size is not a
    // multiple of eight), and the corners.
    EXPECT_LE(volume.Reads, 9 * 9 * 9 * 125 + 8) << n << "^3";
    EXPECT_GE(volume.Reads, 500 * 125) << n << "^3";
  }
}

TEST(NoiseEstimate, OfALargeVolumeInPiecesIsThatOfTheWhole)
{
  constexpr std::int64_t n = 512;
  Computed volume{ { n, n, n } };
  const NoiseSamples whole = volume.Collect(0, n - 1);
  for (const std::int64_t slabs : { 2, 7, 100 })
  {
    NoiseSamples pieces;
    std::copy_n(whole.Dimensions, 3, pieces.Dimensions);
    for (std::int64_t s = slabs - 1; s >= 0; --s)
    {
      pieces.Merge(volume.Collect(s * n / slabs, (s + 1) * n / slabs - 1));
    }
    EXPECT_EQ(pieces.Range[0], whole.Range[0]);
    EXPECT_EQ(pieces.Range[1], whole.Range[1]);
    EXPECT_EQ(EstimateNoise(pieces), EstimateNoise(whole)) << slabs << " slabs";
  }
}
