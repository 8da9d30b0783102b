// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples outside of what was measured: NaN around it, as masked maps of SPM and FSL have it, and
 * numbers that stand for missing values.
 *
 * A volume has one decision, made from its corners and its range, so that all pieces and regions of
 * it are felt alike.
 */
#ifndef OutsideSamples_h
#define OutsideSamples_h

#include "Core/Field/NoiseSamples.h"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{

/** Which samples of a volume are outside, and the value with which they are felt. */
struct OutsideSamples
{
  /** Whether NaN and infinity are: a corner has one. Else they are holes in the data. */
  bool AreNonFinite = false;
  /** The number that stands for missing values; NaN if there is none. */
  double Missing = std::numeric_limits<double>::quiet_NaN();
  /** The least value inside; below it, and 0 if that is, where all inside have one value. */
  double Fill = 0.0;
  /** The share of samples that are no numbers, of those looked at, if these are holes. */
  double Holes = 0.0;

  bool HasAny() const { return this->AreNonFinite || this->Missing == this->Missing; }
  bool Has(double value) const
  {
    return value == this->Missing || (this->AreNonFinite && !std::isfinite(value));
  }
};

/**
 * Whether programs write a number for missing values: -9999 and -99999, the least number of 16 or
 * 32 bits and the one above it, that of 16 bits with the offset of a CT, -2000 of a CT without its
 * sign (63536), 1e20 and others as large.
 */
bool MayBeMissing(double value);

/**
 * Of a whole volume. Numbers that a corner has stand for missing values if they may, and if they
 * lie apart from all other values by a tenth of the range of those, which is not 0.
 */
OutsideSamples FindOutside(const NoiseSamples& samples);

/** Gives the samples outside their value, and corrects the range. */
void FillOutside(const OutsideSamples& outside, NoiseSamples& samples);

} // namespace VolumeHaptics

#endif
