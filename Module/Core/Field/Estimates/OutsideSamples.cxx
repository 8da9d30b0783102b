// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Estimates/OutsideSamples.h"

#include "Core/Field/Estimates/NoiseEstimate.h"

#include <algorithm>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

constexpr double MissingNumbers[] = { -9999.0, -99999.0, -32768.0, -32767.0, -2147483648.0,
  -2147483647.0, -33792.0, -31744.0, 63536.0 };
/**
 * Numbers that stand for missing values, with either sign: those of NetCDF, Ferret and others, and
 * the largest numbers of both floating-point types.
 */
constexpr float EnormousNumbers[] = { 1e20F, 1e30F, 1e34F, 1e35F, 1e36F, 1e37F, 9.96921e36F, 1e38F,
  std::numeric_limits<float>::max() };
/**
 * A number stands for missing values only if it differs from all other values by this fraction of
 * their range.
 */
constexpr double LeastGap = 0.1;

bool IsEnormous(double value)
{
  constexpr double mostFloat = std::numeric_limits<float>::max();
  const double size = std::abs(value);
  return size == std::numeric_limits<double>::max() ||
    (size <= mostFloat &&
      std::find(std::begin(EnormousNumbers), std::end(EnormousNumbers), static_cast<float>(size)) !=
        std::end(EnormousNumbers));
}

/**
 * Computes the smallest and the largest value of all samples that do not stand for missing values.
 * If there are none, the first number is the larger one.
 */
void ComputeInsideRange(const NoiseSamples& samples, double range[2])
{
  std::copy_n(samples.Inside, 2, range);
  if (HasRangeOfAll(samples.Dimensions))
  {
    return;
  }
  for (const double value : samples.Values)
  {
    if (std::isfinite(value) && !MayBeMissing(value))
    {
      const double both[2] = { value, value };
      NoiseSamples::Extend(range, both);
    }
  }
}

} // namespace

bool MayBeMissing(double value)
{
  return std::find(std::begin(MissingNumbers), std::end(MissingNumbers), value) !=
    std::end(MissingNumbers) ||
    IsEnormous(value);
}

OutsideSamples DetectOutside(const NoiseSamples& samples)
{
  OutsideSamples outside;
  double inside[2];
  ComputeInsideRange(samples, inside);
  if (!(inside[0] <= inside[1]))
  {
    return outside; // no sample is inside
  }
  const bool isOneValue = inside[0] == inside[1];
  const auto isFar = [&](double value)
  {
    return !isOneValue &&
      std::max(inside[0] - value, value - inside[1]) > LeastGap * (inside[1] - inside[0]);
  };
  std::size_t holes = 0;
  for (std::size_t s = 0; s < samples.Indices.size(); ++s)
  {
    const double value = samples.Values[s];
    const bool isNumber = std::isfinite(value);
    holes += isNumber ? 0 : 1;
    if ((isNumber && !MayBeMissing(value)) || samples.GetCorner(s) < 0)
    {
      continue;
    }
    if (!isNumber)
    {
      outside.AreNonFinite = true;
    }
    // If several numbers qualify, the smallest one is used, so that the order of the pieces does
    // not matter. If there are only two values, neither stands for missing values.
    else if (isFar(value) && !(outside.Missing <= value))
    {
      outside.Missing = value;
    }
  }
  for (const double end : samples.Range)
  {
    if (std::isnan(outside.Missing) && IsEnormous(end) && isFar(end))
    {
      outside.Missing = end;
    }
  }
  outside.Holes = outside.AreNonFinite || holes == 0
    ? 0.0
    : static_cast<double>(holes) / static_cast<double>(samples.Values.size());
  outside.Fill = !isOneValue ? inside[0] : inside[0] > 0.0 ? 0.0 : inside[0] - 1.0;
  return outside;
}

void FillOutside(const OutsideSamples& outside, NoiseSamples& samples)
{
  if (!outside.HasAny())
  {
    return;
  }
  ComputeInsideRange(samples, samples.Range);
  samples.Range[0] = std::min(samples.Range[0], outside.Fill);
  for (double& value : samples.Values)
  {
    value = outside.Has(value) ? outside.Fill : value;
  }
}

} // namespace VolumeHaptics
