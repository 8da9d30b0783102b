// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Counts the values of a volume and finds the labels in it, for an editor.
 *
 * Visiting all values of a large volume takes seconds, so a worker thread does it. Until it is
 * done, counts of a subset of the samples are shown.
 */
#ifndef HapticHistogram_h
#define HapticHistogram_h

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

class vtkTable;

namespace VolumeHaptics
{

/**
 * Callback with the finished fraction of the work, every few milliseconds. It returns false to stop
 * the work.
 */
using SweepProgress = std::function<bool(double)>;

/** Returns whether all tuples can be visited within 25 ms on a desktop computer of 2023. */
inline bool IsQuicklySwept(vtkDataArray* array)
{
  constexpr vtkIdType most = 1 << 22;
  return array->GetNumberOfTuples() <= most;
}

/**
 * Visits at most 2048 tuples, in 128 pages of memory. The number of pages is small, because reading
 * them takes most of the time if a file is mapped into memory.
 */
template <typename Function>
void VisitSpreadValues(vtkDataArray* array, int component, Function&& visit)
{
  constexpr vtkIdType pages = 1 << 7;
  constexpr vtkIdType looksInPage = 1 << 4;
  constexpr vtkIdType pageSize = 4096; // bytes
  const vtkIdType all = array->GetNumberOfTuples();
  if (all <= pages * looksInPage)
  {
    for (vtkIdType tuple = 0; tuple < all; ++tuple)
    {
      visit(array->GetComponent(tuple, component));
    }
    return;
  }
  const vtkIdType size =
    std::max<vtkIdType>(1, array->GetDataTypeSize() * array->GetNumberOfComponents());
  const vtkIdType step =
    std::clamp<vtkIdType>(pageSize / (looksInPage * size), 1, all / looksInPage);
  // Visit one page in each part of the array, and one tuple in each part of the page. The positions
  // advance by the golden ratio, because equal steps could hit the same column of every row.
  double place = 0.0;
  const auto next = [&place](double stretch)
  {
    constexpr double section = 0.6180339887498949;
    place += section;
    place -= std::floor(place);
    return stretch + place;
  };
  for (vtkIdType page = 0; page < pages; ++page)
  {
    const double at = next(static_cast<double>(page)) / static_cast<double>(pages);
    const auto tuple = static_cast<vtkIdType>(at * static_cast<double>(all));
    const vtkIdType first =
      std::min(tuple - tuple % (looksInPage * step), all - looksInPage * step);
    for (vtkIdType look = 0; look < looksInPage; ++look)
    {
      const double within = next(static_cast<double>(look)) * static_cast<double>(step);
      visit(array->GetComponent(first + static_cast<vtkIdType>(within), component));
    }
  }
}

/**
 * Calls visit(begin, end) for pieces of an array until all tuples are visited; `end` is excluded.
 * This is half of the whole work: the fraction passed to `progress` increases from `from` by 0.5.
 * Returns false if `progress` stopped the work.
 */
template <typename Function>
bool VisitPieces(vtkDataArray* array, double from, const SweepProgress& progress, Function&& visit)
{
  constexpr vtkIdType piece = 1 << 20; // tuples; they take 6 ms
  const vtkIdType all = array->GetNumberOfTuples();
  for (vtkIdType begin = 0; begin < all; begin += piece)
  {
    if (!progress(from + 0.5 * static_cast<double>(begin) / static_cast<double>(all)))
    {
      return false;
    }
    visit(begin, std::min(begin + piece, all));
  }
  return true;
}

/** Largest magnitude in a chart, since charts are drawn in single precision. */
constexpr double FarthestShown = 1e30;

/** Histogram of a component, with at most 128 bins. */
struct ValueCounts
{
  double Range[2] = { 0.0, 1.0 }; ///< range of the finite values, limited to FarthestShown
  double Origin = 0.0;            ///< centre of the first bin
  double Width = 1.0;
  std::vector<vtkIdType> Counts; ///< count per bin; empty if there are no finite values
};

/** Counts a few thousand values, spread over the array. */
ValueCounts CountSpreadValues(vtkDataArray* scalars, int component);

/** Counts all values; returns nothing if the count was stopped. Any thread may call it. */
std::optional<ValueCounts> CountAllValues(
  vtkDataArray* scalars, int component, const SweepProgress& progress);

/**
 * Fills two columns: "value" is the centre of a bin, "share" is log(1 + count), divided by that of
 * the largest bin.
 */
void FillHistogram(const ValueCounts& counts, vtkTable* table);

/** Collects the labels among a few thousand values, spread over the array, in ascending order. */
std::vector<int> CollectSpreadLabels(vtkDataArray* labels);

/**
 * Collects all labels in an array, in ascending order. Skips fractions and numbers outside int,
 * which a vtkHapticLabelTable can't contain. Returns nothing if the search was stopped. Any thread
 * may call it.
 */
std::vector<int> CollectPresentLabels(vtkDataArray* labels, const SweepProgress& progress);

} // namespace VolumeHaptics

#endif
