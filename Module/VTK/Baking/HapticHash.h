// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A hash of a volume, which tells a recording's volume from others.
 */
#ifndef HapticHash_h
#define HapticHash_h

#include <string>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * MD5 of the values of an array, tuple by tuple in any memory layout, and of its shape.
 */
std::string HashArray(vtkDataArray* array, const int dimensions[3]);

/** How long that takes, approximately (s). */
double EstimateHashTime(vtkDataArray* array);

} // namespace VolumeHaptics

#endif
