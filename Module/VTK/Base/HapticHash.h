// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A hash of a volume, which tells a recording's volume from others.
 */
#ifndef HapticHash_h
#define HapticHash_h

#include <functional>
#include <string>

class vtkDataArray;

namespace VolumeHaptics
{

/** Called between pieces of some milliseconds with the share that is done; false ends the work. */
using HashProgress = std::function<bool(double)>;

/**
 * MD5 of the values of an array, tuple by tuple in any memory layout, and of its shape; empty if
 * the work was ended. May be called by another thread than that of the array's owner.
 */
std::string HashArray(
  vtkDataArray* array, const int dimensions[3], const HashProgress& progress = nullptr);

/** How long that takes, approximately (s). */
double EstimateHashTime(vtkDataArray* array);

} // namespace VolumeHaptics

#endif
