// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hashes a volume, so that a recording can recognise its volume.
 */
#ifndef HapticHash_h
#define HapticHash_h

#include <functional>
#include <string>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * Called between pieces of some milliseconds with the fraction that is done; false ends the work.
 */
using HashProgress = std::function<bool(double)>;

/**
 * Computes the MD5 of an array's shape and of its values, tuple by tuple in any memory layout;
 * empty if the work was ended. Any thread may call it, not only that of the array's owner.
 */
std::string HashArray(
  vtkDataArray* array, const int dimensions[3], const HashProgress& progress = nullptr);

/** Estimates how long HashArray() takes (s). */
double EstimateHashTime(vtkDataArray* array);

} // namespace VolumeHaptics

#endif
