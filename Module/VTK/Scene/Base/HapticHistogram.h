// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frequency of a volume's values, for the background of an editor.
 *
 * All values of a large volume take seconds to count: a worker does that in the background, while a
 * count of spread samples is shown.
 */
#ifndef HapticHistogram_h
#define HapticHistogram_h

#include "VTK/Scene/Base/ArraySweep.h"

#include <optional>
#include <vector>

class vtkTable;

namespace VolumeHaptics
{

/** Charts are drawn in single precision: numbers beyond it are not shown. */
constexpr double FarthestShown = 1e30;

/** At most 128 bins of the values of a component. */
struct ValueCounts
{
  double Range[2] = { 0.0, 1.0 }; ///< of the finite values, as far as it can be shown
  double Origin = 0.0;            ///< the middle of the first bin
  double Width = 1.0;
  std::vector<vtkIdType> Counts; ///< empty if there are no finite values
};

/** Counts some thousand values that are spread over the array. */
ValueCounts CountSpreadValues(vtkDataArray* scalars, int component);

/**
 * Counts all values, or nothing if it was ended. May be called by another thread than that of the
 * array's owner.
 */
std::optional<ValueCounts> CountAllValues(
  vtkDataArray* scalars, int component, const SweepProgress& progress);

/**
 * Fills the columns "value" and "share": the middle of the bin, and log(1 + count) as a share of
 * the largest.
 */
void FillHistogram(const ValueCounts& counts, vtkTable* table);

} // namespace VolumeHaptics

#endif
