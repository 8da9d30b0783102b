// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The labels that occur in a label image.
 */
#ifndef HapticPresentLabels_h
#define HapticPresentLabels_h

#include <vector>

class vtkImageData;

namespace VolumeHaptics
{

/** How long FindPresentLabels takes (s) on a desktop computer, approximately. */
double EstimatePresentLabelsTime(vtkImageData* image);

/**
 * The labels in the point scalars of an image, in rising order, without those that no
 * vtkHapticLabelTable can have: beyond int, or no whole numbers. An image may be null.
 */
std::vector<int> FindPresentLabels(vtkImageData* image);

} // namespace VolumeHaptics

#endif
