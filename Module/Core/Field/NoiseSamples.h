// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Collects the samples of a whole volume from which its noise and its border value are estimated.
 *
 * A region of a volume uses the noise and the border value of the whole volume, so that it feels
 * the same. If a volume is in pieces, each piece adds its samples (NoiseEstimate.h): up to 4096
 * blocks of 5^3 samples, or 512 in a large volume, and the corners. Merge() joins the samples of
 * pieces. The data are plain numbers, so that they can be sent between processes directly.
 */
#ifndef NoiseSamples_h
#define NoiseSamples_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace VolumeHaptics
{

/** The samples of one component of an array. */
struct NoiseSamples
{
  /** Dimensions of the whole volume. */
  std::int64_t Dimensions[3] = { 0, 0, 0 };
  /**
   * Numbers of the samples, i + Dimensions[0] (j + Dimensions[1] k) with indices from 0, in any
   * order, and their values.
   */
  std::vector<std::int64_t> Indices;
  std::vector<double> Values;
  /**
   * Smallest and largest value: of all samples if HasRangeOfAll() is true, otherwise of the samples
   * in Values. If there are no samples, the first number is the larger one.
   */
  double Range[2] = { 1.0, 0.0 };
  /**
   * If HasRangeOfAll() is true, the range of all samples that are finite and do not stand for
   * missing values (OutsideSamples.h).
   */
  double Inside[2] = { 1.0, 0.0 };

  /** Returns the index along each axis of sample s. */
  std::array<std::int64_t, 3> ComputePlace(std::size_t s) const
  {
    const std::int64_t number = this->Indices[s];
    return { number % this->Dimensions[0], number / this->Dimensions[0] % this->Dimensions[1],
      number / this->Dimensions[0] / this->Dimensions[1] };
  }

  /**
   * Returns the number of the corner at which sample s is, or -1 if it is not at a corner. Bit a of
   * the number is set if the corner is at the end of axis a.
   */
  int GetCorner(std::size_t s) const
  {
    const std::array<std::int64_t, 3> at = this->ComputePlace(s);
    int corner = 0;
    for (int a = 0; a < 3; ++a)
    {
      if (at[a] != 0 && at[a] != this->Dimensions[a] - 1)
      {
        return -1;
      }
      corner |= at[a] == 0 ? 0 : 1 << a;
    }
    return corner;
  }

  /**
   * Adds the samples of another piece of the same volume. Samples that both pieces have are counted
   * once.
   */
  void Merge(const NoiseSamples& other)
  {
    this->Indices.insert(this->Indices.end(), other.Indices.begin(), other.Indices.end());
    this->Values.insert(this->Values.end(), other.Values.begin(), other.Values.end());
    this->MergeRange(other.Range);
    Extend(this->Inside, other.Inside);
  }

  /** Extends Range by the finite values among `values`. */
  void MergeValues(const double* values, std::size_t count)
  {
    double range[2] = { std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity() };
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool isFinite = std::isfinite(values[i]);
      range[0] = isFinite && values[i] < range[0] ? values[i] : range[0];
      range[1] = isFinite && values[i] > range[1] ? values[i] : range[1];
    }
    this->MergeRange(range);
  }

  void MergeRange(const double range[2]) { Extend(this->Range, range); }

  /** Extends a range so that it includes another one. */
  static void Extend(double to[2], const double range[2])
  {
    if (range[0] > range[1])
    {
      return;
    }
    const bool isFirst = to[0] > to[1];
    to[0] = isFirst ? range[0] : std::min(to[0], range[0]);
    to[1] = isFirst ? range[1] : std::max(to[1], range[1]);
  }
};

} // namespace VolumeHaptics

#endif
