// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Estimates the value at which a volume's background ends and its solid part begins.
 */
#ifndef BackgroundLevel_h
#define BackgroundLevel_h

#include "Core/Field/Estimates/NoiseEstimate.h"

namespace VolumeHaptics
{

/**
 * The values of the two darkest separate materials of a volume. IsThere is false if the volume has
 * no two such materials. Values are means over 3^3 samples in the noise blocks, so that it does not
 * matter whether the volume has few levels or values that are clipped at 0.
 */
struct BackgroundLevel
{
  bool IsThere = false;
  double Threshold = 0.0; ///< value between the two materials
  double Full = 0.0;      ///< value from which on samples are solid; a little above Threshold
  double Dark = 0.0;      ///< median of the background's values
  double Bright = 0.0;    ///< median of the values above the threshold

  /**
   * Computes Otsu's threshold (IEEE Transactions on Systems, Man, and Cybernetics 9, 1979), unless
   * the histogram has a single peak. While the even blocks below the threshold contain a darker
   * material that differs clearly from the background, moves the threshold between this material
   * and the background.
   */
  static BackgroundLevel Estimate(const NoiseSamples& samples);
  /** Computes the same levels, to the bit, for a volume that is in one piece. */
  static BackgroundLevel Estimate(const SampleReader& read, const std::int64_t dimensions[3]);
};

} // namespace VolumeHaptics

#endif
