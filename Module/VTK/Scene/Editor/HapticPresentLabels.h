// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The labels in a label image.
 */
#ifndef HapticPresentLabels_h
#define HapticPresentLabels_h

#include "VTK/Scene/Base/ArraySweep.h"

#include <vector>

namespace VolumeHaptics
{

/** The labels of some thousand values, spread over the array, in ascending order. */
std::vector<int> FindSpreadLabels(vtkDataArray* labels);

/**
 * The labels in an array, in ascending order, without those that no vtkHapticLabelTable can have:
 * numbers beyond int, or not whole. Empty if the search was ended. Another thread than the array
 * owner's may call it.
 */
std::vector<int> FindPresentLabels(vtkDataArray* labels, const SweepProgress& progress);

} // namespace VolumeHaptics

#endif
