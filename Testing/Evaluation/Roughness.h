// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures how rough a force feels while a hand strokes a surface that looks smooth.
 *
 * Hands feel vibration best between 40 and 400 Hz. A force that falls by a third within
 * milliseconds feels like a gap in the surface.
 */
#ifndef Evaluation_Roughness_h
#define Evaluation_Roughness_h

#include <cstddef>
#include <vector>

namespace evaluation
{

/** Roughness of the magnitude of a force during a stroke with one tick per millisecond. */
struct Roughness
{
  double Duration = 0.0;    ///< s
  double Mean = 0.0;        ///< N
  double Low = 0.0;         ///< root mean square between 30 and 100 Hz, % of the mean
  double High = 0.0;        ///< root mean square between 100 and 500 Hz, % of the mean
  double Both = 0.0;        ///< root mean square between 30 and 500 Hz, % of the mean
  int Drops = 0;            ///< falls by more than 30 % within 5 ms
  int Reversals = 0;        ///< rises after falls, each by more than 5 % of the mean
  double LargestStep = 0.0; ///< N, from one tick to the next
};

/** Returns the ticks at the end of a fall by more than 30 % within 5 ms. */
std::vector<std::size_t> DetectDrops(const std::vector<double>& force);

/**
 * Computes the roughness of a force (N per tick). Returns zeros for fewer than 100 ticks, or
 * without force.
 */
Roughness MeasureRoughness(const std::vector<double>& force);

/**
 * Averages several strokes: sums of durations and counts, the largest step, and means weighted by
 * duration. Leaves out strokes without force.
 */
Roughness Average(const std::vector<Roughness>& strokes);

} // namespace evaluation

#endif
