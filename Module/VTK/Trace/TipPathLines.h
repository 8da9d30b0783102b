// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tells whether the line cells of a path form one line, in the order of its points.
 */
#ifndef TipPathLines_h
#define TipPathLines_h

#include <cstddef>
#include <utility>

class vtkPolyData;

namespace VolumeHaptics
{

/** The path has to have finite points. */
class TipPathLines
{
public:
  explicit TipPathLines(vtkPolyData* path)
    : Path(path)
  {
  }

  /**
   * The number of strokes of a pen that draw the line cells: 1 for a polyline and for segments that
   * continue one another, in any order and direction; 0 without line cells.
   */
  std::size_t Count() const;

  /**
   * The first leap: consecutive points of the line cells, in the order in which they are stored,
   * that no cell joins. Returns the points before and after it; -1, -1 if there is none. Points at
   * one position need no cell.
   */
  std::pair<long long, long long> FindLeap() const;

private:
  vtkPolyData* const Path;
};

} // namespace VolumeHaptics

#endif
