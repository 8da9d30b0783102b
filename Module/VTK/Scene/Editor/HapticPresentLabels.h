// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The labels that occur in a label image.
 */
#ifndef HapticPresentLabels_h
#define HapticPresentLabels_h

#include "VTK/Scene/Base/ArraySweep.h"

#include <vector>

namespace VolumeHaptics
{

/** The labels of some thousand values that are spread over the array, in rising order. */
std::vector<int> FindSpreadLabels(vtkDataArray* labels);

/**
 * The labels in an array, in rising order, without those that no vtkHapticLabelTable can have:
 * beyond int, or no whole numbers. None if the search was ended. May be called by another thread
 * than that of the array's owner.
 */
std::vector<int> FindPresentLabels(vtkDataArray* labels, const SweepProgress& progress);

} // namespace VolumeHaptics

#endif
