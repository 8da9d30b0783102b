// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs work on many voxels, on all cores at once or in the background.
 */
#ifndef SearchPart_h
#define SearchPart_h

#include "VTK/Base/BackgroundWork.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>

namespace VolumeHaptics
{

/** A part of a search: the caller waits for it (no monitor), or it runs in the background. */
struct SearchPart
{
  WorkMonitor* Monitor = nullptr;
  ///@{
  /** Progress of the whole search at the beginning and the end of this part. */
  double Begin = 0.0;
  double End = 1.0;
  ///@}

  bool IsCancelled() const { return this->Monitor && this->Monitor->IsCancelled(); }
};

/**
 * Calls look(first, end) for all numbers below `count`: on all cores, or, with a monitor, in pieces
 * on this thread alone, which has a low priority. False if it was cancelled.
 */
template <typename Look>
bool LookAtAll(std::size_t count, std::size_t piece, const SearchPart& part, Look&& look)
{
  if (!part.Monitor)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), look);
    return true;
  }
  for (std::size_t first = 0; first < count; first += piece)
  {
    const double share = static_cast<double>(first) / static_cast<double>(count);
    if (!part.Monitor->GoesOn(part.Begin + share * (part.End - part.Begin)))
    {
      return false;
    }
    look(static_cast<vtkIdType>(first), static_cast<vtkIdType>(std::min(first + piece, count)));
  }
  return !part.IsCancelled();
}

} // namespace VolumeHaptics

#endif
