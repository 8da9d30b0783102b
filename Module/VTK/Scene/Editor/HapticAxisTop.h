// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The top of an axis for an edited quantity.
 */
#ifndef HapticAxisTop_h
#define HapticAxisTop_h

#include <cmath>

namespace VolumeHaptics
{

/** The next round number. */
inline double RoundUp(double value)
{
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : { 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0 })
  {
    if (value <= step * decade * (1.0 + 1e-9))
    {
      return step * decade;
    }
  }
  return 10.0 * decade;
}

} // namespace VolumeHaptics

#endif
