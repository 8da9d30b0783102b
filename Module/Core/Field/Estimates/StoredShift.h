// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The number that turns the stored values of a CT into Hounsfield units when it is added.
 */
#ifndef StoredShift_h
#define StoredShift_h

#include "Core/Field/Estimates/NoiseEstimate.h"

namespace VolumeHaptics
{

/**
 * How Hounsfield units are stored, by the values in the noise blocks. DICOM stores them without
 * sign, usually 1024 higher (its Rescale Intercept, PS3.3 C.7.6.16-2.9), others 1000 or 32768
 * higher: air and soft tissue, the heaps that every CT of a body has, are then there.
 */
struct StoredShift
{
  double Shift = 0.0; ///< to add; 0 if the values are Hounsfield units as they are
  double Air = 0.0;   ///< the value of air, if there is a shift
  /** Whether the values can't be Hounsfield units: there is neither air nor soft tissue. */
  bool IsStrange = false;
  double Range[2] = { 1.0, 0.0 }; ///< of the values looked at; the first is larger without any

  static StoredShift Find(const NoiseSamples& samples);
  /** The same, to the bit, of a volume that is no piece. */
  static StoredShift Find(const SampleReader& read, const std::int64_t dimensions[3]);
};

} // namespace VolumeHaptics

#endif
