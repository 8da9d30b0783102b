// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A fingerprint of a volume, by which a recording knows what it was made on.
 */
#ifndef HapticHash_h
#define HapticHash_h

#include <string>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * MD5 of the values of an array, tuple by tuple in whatever layout they lie in memory, and of how
 * it is shaped.
 */
std::string HashArray(vtkDataArray* array, const int dimensions[3]);

/** How long that takes, about (s). */
double EstimateHashTime(vtkDataArray* array);

} // namespace VolumeHaptics

#endif
