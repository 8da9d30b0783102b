// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the number to add to a CT's stored values to get Hounsfield units.
 */
#ifndef StoredShift_h
#define StoredShift_h

#include "Core/Field/Estimates/NoiseEstimate.h"

namespace VolumeHaptics
{

/**
 * The shift with which a volume stores Hounsfield units, estimated from the values in the noise
 * blocks. DICOM stores them without sign, usually 1024 higher (its Rescale Intercept, PS3.3
 * C.7.6.16-2.9). Other formats store them 1000 or 32768 higher. The shift is found from air and
 * soft tissue, the two peaks in every CT of a body.
 */
struct StoredShift
{
  double Shift = 0.0; ///< number to add to stored values; 0 if they are Hounsfield units
  double Air = 0.0;   ///< stored value of air if there is a shift
  /** Whether the values can't be Hounsfield units, because there is neither air nor soft tissue. */
  bool IsStrange = false;
  /** Range of the values that were read. If none was read, the first number is the larger one. */
  double Range[2] = { 1.0, 0.0 };

  static StoredShift Estimate(const NoiseSamples& samples);
  /** Estimates the same shift, to the bit, for a volume in one piece. */
  static StoredShift Estimate(const SampleReader& read, const std::int64_t dimensions[3]);
};

} // namespace VolumeHaptics

#endif
