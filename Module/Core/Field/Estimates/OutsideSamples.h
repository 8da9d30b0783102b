// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds samples outside the measurement. They are NaN around it, as in masked maps of SPM and FSL,
 * or numbers that stand for missing values.
 *
 * The decision is made once for a whole volume, from its corners and its range, and applies to all
 * its pieces and regions.
 */
#ifndef OutsideSamples_h
#define OutsideSamples_h

#include "Core/Field/NoiseSamples.h"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{

/**
 * Describes which samples of a volume are outside the measurement, and the value that replaces
 * them.
 */
struct OutsideSamples
{
  /**
   * Whether NaN and infinity are outside, which is so if a corner has such a value. Otherwise they
   * are holes in the data.
   */
  bool AreNonFinite = false;
  /** Number that stands for missing values; NaN if there is none. */
  double Missing = std::numeric_limits<double>::quiet_NaN();
  /**
   * Value that replaces samples outside. It is the smallest value inside. If all values inside are
   * equal, it is 0 if they are above 0, and otherwise one less than they are.
   */
  double Fill = 0.0;
  /** Fraction of the read samples that are NaN or infinite, if these are holes. */
  double Holes = 0.0;

  bool HasAny() const { return this->AreNonFinite || this->Missing == this->Missing; }
  bool Has(double value) const
  {
    return value == this->Missing || (this->AreNonFinite && !std::isfinite(value));
  }
};

/**
 * Returns whether programs commonly write this number for missing values. Such numbers are -9999
 * and -99999; the least number of 16 or 32 bits and the number above it; the least number of 16
 * bits with a CT's offset; 63536, which is a CT's -2000 read without sign; and numbers of 1e20 and
 * more.
 */
bool MayBeMissing(double value);

/**
 * Finds the samples of a whole volume that are outside. A number in a corner stands for missing
 * values if MayBeMissing() returns true, and if it differs from all other values by at least a
 * tenth of their range, which must not be 0. From 1e20 on, it does so in any place.
 */
OutsideSamples DetectOutside(const NoiseSamples& samples);

/** Sets the samples outside to OutsideSamples::Fill, and corrects the range. */
void FillOutside(const OutsideSamples& outside, NoiseSamples& samples);

} // namespace VolumeHaptics

#endif
