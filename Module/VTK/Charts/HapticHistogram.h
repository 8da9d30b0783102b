// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frequency of a volume's values, for the background of an editor.
 */
#ifndef HapticHistogram_h
#define HapticHistogram_h

class vtkImageData;
class vtkTable;

namespace VolumeHaptics
{

/** Charts are drawn in single precision: numbers beyond it are not shown. */
constexpr double FarthestShown = 1e30;

/**
 * Fills the columns "value" and "share" with at most 128 bins of a component of the scalars: the
 * middle of the bin, and log(1 + count) as a share of the largest. `range` is that of the scalars,
 * as far as it can be shown. If there are no finite scalars, returns false and an empty table.
 */
bool FillHistogram(vtkImageData* image, int component, vtkTable* table, double range[2]);

/** How long that takes, approximately (s). */
double EstimateHistogramTime(vtkImageData* image);

} // namespace VolumeHaptics

#endif
