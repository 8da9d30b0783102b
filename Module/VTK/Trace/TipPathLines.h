// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tells whether the line cells of a path are one line, in the order of its points.
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
   * How many strokes of a pen draw the line cells: 1 for a polyline and for segments that continue
   * one another, in whatever order and direction they are stored; 0 without line cells.
   */
  std::size_t Count() const;

  /**
   * The first place at which the points of the line cells, in the order in which they are stored,
   * go on without a cell that joins them: the last point before this leap, and the first after it;
   * -1, -1 if there is none. Points at one position need no cell.
   */
  std::pair<long long, long long> FindLeap() const;

private:
  vtkPolyData* const Path;
};

} // namespace VolumeHaptics

#endif
