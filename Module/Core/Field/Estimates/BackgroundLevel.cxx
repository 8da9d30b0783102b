// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Estimates/BackgroundLevel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace VolumeHaptics
{
namespace
{
/**
 * The volume has a background and a solid part if the difference between them accounts for this
 * fraction of the variance of all values. For the halves of a normal distribution it is 0.637.
 */
constexpr double ApartFraction = 0.65;
/**
 * A block is even if its values differ by at most this fraction of the rise from background to
 * solid.
 */
constexpr double EvenFraction = 0.15;
///@{
/**
 * A darker material is accepted if its difference from the background accounts for this fraction of
 * the variance among the even blocks.
 */
constexpr double DarkFraction = 0.88;
/**
 * Least rise of the darker material as a fraction of the brighter material's rise, and least
 * fraction of the even blocks that it must fill.
 */
constexpr double LeastRise = 0.1;
constexpr double LeastPart = 0.01;
///@}
constexpr std::size_t LeastBlocks = 64;
/**
 * Distance from the threshold to Full, as a fraction of the distance from the threshold to the
 * solid's median.
 */
constexpr double FullFraction = 0.15;
constexpr int Inner = NoiseBlockSide - 2; // number of means along each axis of a block

/** The mean of a block's means, and the difference between the largest and the smallest of them. */
struct BlockMeans
{
  double Mean;
  double Span;
};

class ValueHeaps
{
public:
  void Add(const double* block)
  {
    double sum = 0.0;
    double low = 0.0;
    double high = 0.0;
    double means[Inner * Inner * Inner];
    for (int i = 0; i < Inner * Inner * Inner; ++i)
    {
      const double mean = ComputeMean(block, i);
      means[i] = mean;
      sum += mean;
      low = i == 0 ? mean : std::min(low, mean);
      high = i == 0 ? mean : std::max(high, mean);
    }
    if (std::isfinite(sum))
    {
      this->All.insert(this->All.end(), std::begin(means), std::end(means));
      this->Blocks.push_back({ sum / (Inner * Inner * Inner), high - low });
    }
  }

  BackgroundLevel Estimate()
  {
    std::sort(this->All.begin(), this->All.end());
    Split split = ComputeSplit(this->All);
    if (split.Fraction < ApartFraction)
    {
      return {};
    }
    double background = this->All[split.Below / 2];
    double solid = this->All[(split.Below + this->All.size()) / 2];
    BackgroundLevel level;
    level.IsThere = true;
    level.Threshold = 0.5 * (this->All[split.Below - 1] + this->All[split.Below]);
    const double rise = solid - background;
    // A value between background and solid may belong to an edge, so only even blocks can show a
    // darker material.
    std::vector<double> even;
    for (const BlockMeans& block : this->Blocks)
    {
      if (block.Span <= EvenFraction * rise && block.Mean < level.Threshold)
      {
        even.push_back(block.Mean);
      }
    }
    std::sort(even.begin(), even.end());
    while (even.size() >= LeastBlocks)
    {
      split = ComputeSplit(even);
      const double low = even[split.Below / 2];
      const double high = even[(split.Below + even.size()) / 2];
      const auto all = static_cast<double>(even.size());
      if (split.Fraction < DarkFraction || high - low < LeastRise * rise ||
        all - static_cast<double>(split.Below) < LeastPart * all)
      {
        break;
      }
      background = low;
      solid = high;
      level.Threshold = 0.5 * (low + high);
      even.resize(split.Below);
    }
    level.Full = level.Threshold + FullFraction * (solid - level.Threshold);
    level.Dark = background;
    const auto above = std::lower_bound(this->All.begin(), this->All.end(), level.Threshold);
    level.Bright = *(above + (this->All.end() - above) / 2);
    return level;
  }

private:
  /**
   * A split of ascending values: the number of values below the threshold, and the fraction of the
   * variance that the split accounts for.
   */
  struct Split
  {
    std::size_t Below = 0;
    double Fraction = 0.0;
  };

  static double ComputeMean(const double* block, int i)
  {
    const int x = i % Inner;
    const int y = i / Inner % Inner;
    const int z = i / (Inner * Inner);
    double sum = 0.0;
    for (int c = z; c < z + 3; ++c)
    {
      for (int b = y; b < y + 3; ++b)
      {
        const double* const row = block + x + NoiseBlockSide * (b + NoiseBlockSide * c);
        sum += row[0] + row[1] + row[2];
      }
    }
    return sum / 27.0;
  }

  /** Returns the split at Otsu's threshold, which maximises the fraction. */
  static Split ComputeSplit(const std::vector<double>& values)
  {
    // Subtracted from all values, so that the sums keep their precision.
    const double first = values.empty() ? 0.0 : values.front();
    double sum = 0.0;
    double squares = 0.0;
    for (const double value : values)
    {
      sum += value - first;
      squares += (value - first) * (value - first);
    }
    const auto all = static_cast<double>(values.size());
    const double variance = squares - sum * sum / all;
    Split best;
    double below = 0.0;
    for (std::size_t i = 1; i < values.size() && variance > 0.0; ++i)
    {
      below += values[i - 1] - first;
      const auto n = static_cast<double>(i);
      const double gap = below / n - (sum - below) / (all - n);
      const double fraction = n * (all - n) / all * gap * gap / variance;
      if (values[i] > values[i - 1] && fraction > best.Fraction)
      {
        best = { i, fraction };
      }
    }
    return best;
  }

  std::vector<double> All;
  std::vector<BlockMeans> Blocks;
};

} // namespace

BackgroundLevel BackgroundLevel::Estimate(const NoiseSamples& samples)
{
  return EstimateInNoiseBlocks<ValueHeaps>(samples);
}

BackgroundLevel BackgroundLevel::Estimate(
  const SampleReader& read, const std::int64_t dimensions[3])
{
  return EstimateInNoiseBlocks<ValueHeaps>(read, dimensions);
}

} // namespace VolumeHaptics
