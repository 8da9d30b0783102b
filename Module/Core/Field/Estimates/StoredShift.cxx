// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Estimates/StoredShift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Values (HU) of air and lung, without padding. In data that are not shifted, at least
 * LeastFraction of all values are among them.
 */
constexpr double SurelyAir[2] = { -1200.0, -200.0 };
constexpr double LeastFraction = 0.005;
/**
 * Values (HU) of air and of soft tissue, and values between them, which occur in lungs and at
 * edges.
 */
constexpr double AirValues[2] = { -1030.0, -850.0 };
constexpr double BrightestAir = -940.0; // the brightest air outside lungs
constexpr double BetweenValues[2] = { -700.0, -400.0 };
constexpr double TissueValues[2] = { -150.0, 150.0 };
/** Least ratio of the number of values in a peak to the number between the peaks. */
constexpr double HeapRatio = 2.0;
constexpr double Air = -1000.0;
constexpr double Offsets[] = { 1024.0, 32768.0 };
/**
 * Largest stored value that counts as negative. Shifted data have almost no such values, because
 * the shift makes all values positive.
 */
constexpr double Negative = -0.5;
/**
 * Least fraction of the values in the tissue's range that must differ from the most frequent one.
 * Real tissue is noisy; a synthetic block of 1000 HU in a block of 0 HU is no body in air.
 */
constexpr double LeastSpread = 0.5;
/**
 * Value (HU) below which there is only padding, and the largest distance (HU) of air from its
 * value.
 */
constexpr double DarkerThanAir = -1100.0;
constexpr double NearAir = 20.0;
/**
 * Difference between the two usual offsets. If air fits the other offset better, that offset was
 * used to store the data.
 */
constexpr double OtherOffset = 1000.0;
/**
 * The largest Hounsfield unit, that of metal on an extended scale, and a value below which every
 * body has fat.
 */
constexpr double MostUnits = 32767.0;
constexpr double LeastOfTissue = 200.0;
/**
 * Least span of the values in a CT. It is small because a CT may be masked, for example to show
 * only a brain.
 */
constexpr double LeastSpan = 20.0;

class SortedValues
{
public:
  void Add(const double* block)
  {
    constexpr int size = NoiseBlockSide * NoiseBlockSide * NoiseBlockSide;
    std::copy_if(block, block + size, std::back_inserter(this->All),
      [](double value) { return std::isfinite(value); });
  }

  StoredShift Estimate()
  {
    std::vector<double>& all = this->All;
    StoredShift found;
    if (all.empty())
    {
      return found;
    }
    std::sort(all.begin(), all.end());
    found.Range[0] = all.front();
    found.Range[1] = all.back();
    const auto count = static_cast<double>(all.size());
    if (this->Count(SurelyAir[0], SurelyAir[1]) >= LeastFraction * count)
    {
      found.IsStrange = found.Range[1] - found.Range[0] < LeastSpan;
      return found;
    }
    if (this->CountWithout(-HUGE_VAL, Negative) < LeastFraction * count && this->DetectShift(found))
    {
      return found;
    }
    found.IsStrange = found.Range[1] - found.Range[0] < LeastSpan ||
      found.Range[0] > LeastOfTissue || found.Range[1] > MostUnits;
    return found;
  }

private:
  /**
   * Looks for the peaks of air and soft tissue at each known offset. Writes the shift to `found`.
   * Returns false if no offset fits.
   */
  bool DetectShift(StoredShift& found) const
  {
    const auto count = static_cast<double>(this->All.size());
    for (const double offset : Offsets)
    {
      const double heap = this->Count(AirValues[0] + offset, AirValues[1] + offset);
      const double between = this->Count(BetweenValues[0] + offset, BetweenValues[1] + offset);
      const double tissue = this->Count(TissueValues[0] + offset, TissueValues[1] + offset);
      if (std::min(heap, tissue) < std::max(LeastFraction * count, HeapRatio * between) ||
        this->CountWithout(TissueValues[0] + offset, TissueValues[1] + offset) <
          LeastSpread * tissue ||
        this->CountWithout(-HUGE_VAL, DarkerThanAir + offset) >= LeastFraction * count)
      {
        continue;
      }
      const double air = this->EstimateAir(AirValues[0] + offset, BrightestAir + offset);
      const double usual = std::abs(air - (Air + offset));
      const double other = offset == Offsets[0] ? std::abs(air - (Air + OtherOffset)) : HUGE_VAL;
      if (std::min(usual, other) <= NearAir)
      {
        found.Air = air;
        found.Shift = other < usual ? -OtherOffset : -offset;
        return true;
      }
    }
    return false;
  }

  double Count(double low, double high) const
  {
    const auto from = std::lower_bound(this->All.begin(), this->All.end(), low);
    return static_cast<double>(std::upper_bound(from, this->All.end(), high) - from);
  }

  /** Returns the values from `low` to `high` without the most frequent value, which is padding. */
  std::vector<double> Without(double low, double high) const
  {
    const auto first = std::lower_bound(this->All.begin(), this->All.end(), low);
    const auto last = std::upper_bound(first, this->All.end(), high);
    auto pad = std::make_pair(first, first);
    for (auto from = first; from != last;)
    {
      const auto to = std::upper_bound(from, last, *from);
      pad = to - from > pad.second - pad.first ? std::make_pair(from, to) : pad;
      from = to;
    }
    std::vector<double> values(first, pad.first);
    values.insert(values.end(), pad.second, last);
    return values;
  }

  double CountWithout(double low, double high) const
  {
    return static_cast<double>(this->Without(low, high).size());
  }

  /**
   * Returns the middle of the shortest interval that has half of the values from `low` to `high`.
   * Leaves out the most frequent value, because other values may have been clipped to it, unless
   * too few values remain.
   */
  double EstimateAir(double low, double high) const
  {
    std::vector<double> values = this->Without(low, high);
    if (static_cast<double>(values.size()) < LeastFraction * static_cast<double>(this->All.size()))
    {
      const auto first = std::lower_bound(this->All.begin(), this->All.end(), low);
      values.assign(first, std::upper_bound(first, this->All.end(), high));
    }
    const std::size_t half = values.size() / 2;
    double best[2] = { low, high };
    for (std::size_t i = 0; i + half < values.size(); ++i)
    {
      if (values[i + half] - values[i] < best[1] - best[0])
      {
        best[0] = values[i];
        best[1] = values[i + half];
      }
    }
    return 0.5 * (best[0] + best[1]);
  }

  std::vector<double> All;
};

} // namespace

StoredShift StoredShift::Estimate(const NoiseSamples& samples)
{
  return EstimateInNoiseBlocks<SortedValues>(samples);
}

StoredShift StoredShift::Estimate(const SampleReader& read, const std::int64_t dimensions[3])
{
  return EstimateInNoiseBlocks<SortedValues>(read, dimensions);
}

} // namespace VolumeHaptics
