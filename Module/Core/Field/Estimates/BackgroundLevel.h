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
 * The darkest two separate materials of a volume; nothing if there are none. Values are means over
 * 3^3 samples within the noise blocks, so that neither few levels nor values that are clipped at 0
 * matter.
 */
struct BackgroundLevel
{
  bool IsThere = false;
  double Threshold = 0.0; ///< between the two
  double Full = 0.0;      ///< a little above: values from here on are solid
  double Dark = 0.0;      ///< the median of the background
  double Bright = 0.0;    ///< the median of what is brighter than the threshold

  /**
   * Otsu's threshold (IEEE Transactions on Systems, Man, and Cybernetics 9, 1979), unless the
   * values are one heap. As long as a darker material stands out of the background in places where
   * values are even, the threshold becomes the one between these, and so on.
   */
  static BackgroundLevel Estimate(const NoiseSamples& samples);
  /** As above, to the bit, for a volume that is not a piece. */
  static BackgroundLevel Estimate(const SampleReader& read, const std::int64_t dimensions[3]);
};

} // namespace VolumeHaptics

#endif
