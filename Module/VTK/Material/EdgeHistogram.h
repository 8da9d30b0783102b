// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Counts how often a volume's values and gradient magnitudes occur together: edges appear as arcs.
 */
#ifndef EdgeHistogram_h
#define EdgeHistogram_h

#include <vector>

namespace VolumeHaptics
{

struct HapticVolume;
struct SearchPart;

struct EdgeHistogram
{
  static constexpr int Columns = 128; ///< columns of values, from Values[0] to Values[1]
  static constexpr int Rows = 64;     ///< rows of gradient magnitudes, from 0 to MostSlope

  double Values[2] = { 0.0, 1.0 };
  double MostSlope = 1.0; ///< scalar units per world unit
  /**
   * Frequencies row by row from gradient 0 on: log(1 + count) as a fraction of the largest one
   * beyond the lowest gradients, at most 1; empty without data.
   */
  std::vector<double> Shares;
};

/**
 * Fills the Shares from some hundred thousand voxels of a volume, with the gradients of a kernel.
 * Gradients above MostSlope do not count. Leaves no Shares if it is cancelled.
 */
void CountEdges(
  const HapticVolume& volume, int kernelRadius, const SearchPart& part, EdgeHistogram& histogram);

} // namespace VolumeHaptics

#endif
