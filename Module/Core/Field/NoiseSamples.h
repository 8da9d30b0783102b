// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What has to be known of a whole volume to touch a region of it: samples that any piece of it may
 * give.
 *
 * The noise (HapticNoise.h) is estimated from some thousand blocks of 5^3 samples, and the border
 * value is that of a corner. Where a volume is in pieces, each piece gives the samples that it
 * holds; blocks that pieces share come together when they are merged. Plain numbers, which can be
 * sent as they are.
 */
#ifndef NoiseSamples_h
#define NoiseSamples_h

#include <algorithm>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** Of one component of an array. */
struct NoiseSamples
{
  /** Of the whole volume. */
  std::int64_t Dimensions[3] = { 0, 0, 0 };
  /**
   * Numbers of samples, i + Dimensions[0] (j + Dimensions[1] k) with indices from 0, in any order,
   * and their values.
   */
  std::vector<std::int64_t> Indices;
  std::vector<double> Values;
  /**
   * Smallest and largest value of all samples of the pieces; the first is the larger where there
   * are none.
   */
  double Range[2] = { 1.0, 0.0 };

  /** Takes what another piece of the same volume gave; what both gave counts once. */
  void Merge(const NoiseSamples& other)
  {
    this->Indices.insert(this->Indices.end(), other.Indices.begin(), other.Indices.end());
    this->Values.insert(this->Values.end(), other.Values.begin(), other.Values.end());
    this->MergeRange(other.Range);
  }

  void MergeRange(const double range[2])
  {
    if (range[0] > range[1])
    {
      return;
    }
    const bool isFirst = this->Range[0] > this->Range[1];
    this->Range[0] = isFirst ? range[0] : std::min(this->Range[0], range[0]);
    this->Range[1] = isFirst ? range[1] : std::max(this->Range[1], range[1]);
  }
};

} // namespace VolumeHaptics

#endif
