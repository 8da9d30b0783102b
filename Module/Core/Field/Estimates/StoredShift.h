// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The number to add to the stored values of a CT to get Hounsfield units.
 */
#ifndef StoredShift_h
#define StoredShift_h

#include "Core/Field/Estimates/NoiseEstimate.h"

namespace VolumeHaptics
{

/**
 * How Hounsfield units are stored, according to the values in the noise blocks. DICOM stores them
 * without sign, usually 1024 higher (its Rescale Intercept, PS3.3 C.7.6.16-2.9), other formats 1000
 * or 32768 higher. Air and soft tissue, the two peaks in every CT of a body, are then at shifted
 * values.
 */
struct StoredShift
{
  double Shift = 0.0; ///< number to add to stored values; 0 if they are Hounsfield units
  double Air = 0.0;   ///< the stored value of air, if there is a shift
  /** Whether the values can't be Hounsfield units: there is neither air nor soft tissue. */
  bool IsStrange = false;
  double Range[2] = { 1.0, 0.0 }; ///< the range of the values that were read; the first is larger
                                  ///< if there are none

  static StoredShift Estimate(const NoiseSamples& samples);
  /** Estimates the same shift, to the bit, for a volume that is not a piece. */
  static StoredShift Estimate(const SampleReader& read, const std::int64_t dimensions[3]);
};

} // namespace VolumeHaptics

#endif
