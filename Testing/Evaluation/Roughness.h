// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How rough a force feels while a hand strokes a surface that looks smooth.
 *
 * Hands feel vibration best between 40 and 400 Hz. A force that falls by a third within
 * milliseconds is felt as a gap in the surface.
 */
#ifndef Evaluation_Roughness_h
#define Evaluation_Roughness_h

#include <cstddef>
#include <vector>

namespace evaluation
{

/** The magnitude of a force during a stroke of one tick a millisecond. */
struct Roughness
{
  double Duration = 0.0;    ///< s
  double Mean = 0.0;        ///< N
  double Low = 0.0;         ///< root mean square between 30 and 100 Hz, % of the mean
  double High = 0.0;        ///< the same between 100 and 500 Hz
  double Both = 0.0;        ///< the same between 30 and 500 Hz
  int Drops = 0;            ///< falls by more than 30 % within 5 ms
  int Reversals = 0;        ///< rises after falls, each by more than 5 % of the mean
  double LargestStep = 0.0; ///< N, from one tick to the next
};

/** The ticks at which a fall by more than 30 % within the last 5 ms ends. */
std::vector<std::size_t> DetectDrops(const std::vector<double>& force);

/** Of a force (N) a tick; all zero for fewer than 100 ticks, or without force. */
Roughness MeasureRoughness(const std::vector<double>& force);

/**
 * Of several strokes: sums of durations and counts, the largest step, and means weighted by
 * duration. Strokes without force are left out.
 */
Roughness Average(const std::vector<Roughness>& strokes);

} // namespace evaluation

#endif
