// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples outside of the measurement: NaN around it, as in masked maps of SPM and FSL, and numbers
 * that stand for missing values.
 *
 * A volume has one decision, made from its corners and its range, so that all its pieces and
 * regions are felt alike.
 */
#ifndef OutsideSamples_h
#define OutsideSamples_h

#include "Core/Field/NoiseSamples.h"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{

/** The samples of a volume that are outside, and the value with which they are felt. */
struct OutsideSamples
{
  /**
   * Whether NaN and infinity are outside, because a corner has such a value. Otherwise they are
   * holes in the data.
   */
  bool AreNonFinite = false;
  /** The number that stands for missing values; NaN if there is none. */
  double Missing = std::numeric_limits<double>::quiet_NaN();
  /**
   * The value with which samples outside are felt: the least value inside. If all values inside are
   * equal, a lower value: 0 if that is lower, else one less.
   */
  double Fill = 0.0;
  /** If NaN and infinity are holes: the fraction of such samples among those read. */
  double Holes = 0.0;

  bool HasAny() const { return this->AreNonFinite || this->Missing == this->Missing; }
  bool Has(double value) const
  {
    return value == this->Missing || (this->AreNonFinite && !std::isfinite(value));
  }
};

/**
 * Returns whether programs write this number for missing values: -9999 and -99999; the least number
 * of 16 or 32 bits and the one above it; the least number of 16 bits with a CT's offset; 63536,
 * which is a CT's -2000 read without sign; 1e20 and numbers as large.
 */
bool MayBeMissing(double value);

/**
 * Finds the samples of a whole volume that are outside. Numbers in a corner stand for missing
 * values if MayBeMissing says so, and if the distance to all other values is at least a tenth of
 * the other values' range, which is not 0.
 */
OutsideSamples DetectOutside(const NoiseSamples& samples);

/** Sets the samples outside to OutsideSamples::Fill, and corrects the range. */
void FillOutside(const OutsideSamples& outside, NoiseSamples& samples);

} // namespace VolumeHaptics

#endif
