// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the paths that the line cells of a polydata form.
 */
#ifndef TipPathLines_h
#define TipPathLines_h

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

/** The points of several paths, one path after another. */
struct DividedPoints
{
  std::vector<vtkIdType> Points; ///< empty if they are 0, 1, 2 ...
  std::vector<vtkIdType> Begins; ///< begin of each path in Points; then the end of the last path
  vtkIdType Count = 0;           ///< number of all points

  void Append(const vtkIdType* ids, vtkIdType count);
  /** Returns the point that was appended last. */
  vtkIdType GetLast() const { return this->Points.empty() ? this->Count - 1 : this->Points.back(); }
};

/**
 * Divides a polydata into paths. A polydata with at most one line cell is one path, through all its
 * points in the order in which they are stored. Segments (cells of two points) that one stroke of a
 * pen draws are also one path. Otherwise each line cell is a path through its own points; segments
 * that continue one another form one path. The points have to be finite.
 */
class TipPathLines
{
public:
  explicit TipPathLines(vtkPolyData* path)
    : Path(path)
  {
  }

  /** Whether the polydata is one path; also true without points. */
  bool IsOne() const;

  /**
   * Finds the first leap: consecutive points of the line cells, in the order in which they are
   * stored, that no cell joins. Returns the points before and after the leap; -1, -1 if there is
   * none. Points at one position need no cell.
   */
  std::pair<long long, long long> FindLeap() const;

  /**
   * Returns several paths in the order of the cells. An empty cell is a path without points. False,
   * with an error, if a cell has a point that does not exist.
   */
  bool Divide(DividedPoints& divided, std::string& error) const;

private:
  bool IsOfSegments() const;
  /**
   * Counts the strokes of a pen that draw the line cells: 1 for segments that continue one another,
   * in any order and direction; 0 without line cells.
   */
  std::size_t CountStrokes() const;

  vtkPolyData* const Path;
};

} // namespace VolumeHaptics

#endif
