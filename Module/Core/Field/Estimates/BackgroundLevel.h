// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The value at which the background of a volume ends and the solid part begins.
 */
#ifndef BackgroundLevel_h
#define BackgroundLevel_h

#include "Core/Field/Estimates/NoiseEstimate.h"

namespace VolumeHaptics
{

/**
 * The levels of the darkest two separate materials of a volume; nothing if the volume has no two
 * such materials. Values are means over 3^3 samples within the noise blocks, so that neither few
 * levels nor values that are clipped at 0 matter.
 */
struct BackgroundLevel
{
  bool IsThere = false;
  double Threshold = 0.0; ///< the value between the two materials
  double Full = 0.0;      ///< a little above: values from here on are solid
  double Dark = 0.0;      ///< the median of the background
  double Bright = 0.0;    ///< the median of the values above the threshold

  /**
   * Computes Otsu's threshold (IEEE Transactions on Systems, Man, and Cybernetics 9, 1979), unless
   * the histogram has a single peak. As long as a darker material stands out from the background in
   * even places, the threshold moves down between this material and the background.
   */
  static BackgroundLevel Estimate(const NoiseSamples& samples);
  /** Computes the same levels, to the bit, for a volume that is not a piece. */
  static BackgroundLevel Estimate(const SampleReader& read, const std::int64_t dimensions[3]);
};

} // namespace VolumeHaptics

#endif
