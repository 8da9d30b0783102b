// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frequency of a volume's values, for the background of an editor.
 *
 * All values of a large volume take seconds to count: a worker counts them in the background, while
 * a count of spread samples is shown.
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
  double Range[2] = { 0.0, 1.0 }; ///< the finite values, as far as a chart can show them
  double Origin = 0.0;            ///< the middle of the first bin
  double Width = 1.0;
  std::vector<vtkIdType> Counts; ///< empty if there are no finite values
};

/** Counts some thousand values, spread over the array. */
ValueCounts CountSpreadValues(vtkDataArray* scalars, int component);

/**
 * Counts all values, or nothing if it was ended. Another thread than the array owner's may call it.
 */
std::optional<ValueCounts> CountAllValues(
  vtkDataArray* scalars, int component, const SweepProgress& progress);

/**
 * Fills the columns "value" and "share": the middle of the bin, and log(1 + count) relative to the
 * largest.
 */
void FillHistogram(const ValueCounts& counts, vtkTable* table);

} // namespace VolumeHaptics

#endif
