// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ways through the tuples of an array that may be large: a few that are spread over it at once,
 * or all of them in pieces.
 */
#ifndef ArraySweep_h
#define ArraySweep_h

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace VolumeHaptics
{

/** Called between pieces of some milliseconds with the share that is done; false ends the work. */
using SweepProgress = std::function<bool(double)>;

/** Whether all tuples are visited within 25 ms, on a desktop computer of 2023. */
inline bool IsQuicklySwept(vtkDataArray* array)
{
  constexpr vtkIdType most = 1 << 22;
  return array->GetNumberOfTuples() <= most;
}

/** Visits the values of 2048 tuples at most, which are 8 MiB of a file mapped into memory. */
template <typename Function>
void VisitSpreadValues(vtkDataArray* array, int component, Function&& visit)
{
  constexpr vtkIdType most = 1 << 11;
  const vtkIdType all = array->GetNumberOfTuples();
  const vtkIdType looks = std::min(all, most);
  // One in each of as many stretches, at a place that moves by the golden section: even steps could
  // fall into the same column of every row.
  constexpr double section = 0.6180339887498949;
  double place = 0.0;
  for (vtkIdType look = 0; look < looks; ++look)
  {
    place += section;
    place -= std::floor(place);
    const double at = (static_cast<double>(look) + place) / static_cast<double>(looks);
    const auto tuple = static_cast<vtkIdType>(at * static_cast<double>(all));
    visit(array->GetComponent(std::min(tuple, all - 1), component));
  }
}

/**
 * Visits all tuples in pieces, from the first to the one before the second number; the share that
 * is done begins at `from` and grows by a half. False if it was ended.
 */
template <typename Function>
bool VisitPieces(vtkDataArray* array, double from, const SweepProgress& progress, Function&& visit)
{
  constexpr vtkIdType piece = 1 << 20; // tuples: 6 ms
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

} // namespace VolumeHaptics

#endif
