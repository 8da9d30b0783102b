// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/TipPathLines.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Counts the points at which cells of the path begin or end; two at one position count as one. */
class Junctions
{
public:
  explicit Junctions(std::size_t ends)
    : Root(ends)
  {
    std::iota(this->Root.begin(), this->Root.end(), std::size_t(0));
  }
  std::size_t Find(std::size_t end)
  {
    while (this->Root[end] != end)
    {
      end = this->Root[end] = this->Root[this->Root[end]];
    }
    return end;
  }
  void Join(std::size_t a, std::size_t b) { this->Root[this->Find(a)] = this->Find(b); }

private:
  std::vector<std::size_t> Root;
};

/** Computes the tolerance for the coordinates of two points at one position. */
double FindRounding(vtkPolyData* path)
{
  double bounds[6];
  path->GetPoints()->GetBounds(bounds);
  constexpr double rounding = 1e-6;
  return rounding *
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

/** Calls a function with each line cell: the number of its points, and their ids. */
template <typename F>
void ForEachLine(vtkPolyData* path, F&& take)
{
  const auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(path->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    take(size, ids);
  }
}

/** Calls a function with both ends of each edge of the line cells. */
template <typename F>
void ForEachEdge(vtkPolyData* path, F&& take)
{
  const vtkIdType points = path->GetNumberOfPoints();
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 1; i < size; ++i)
      {
        if (std::min(ids[i - 1], ids[i]) >= 0 && std::max(ids[i - 1], ids[i]) < points)
        {
          take(ids[i - 1], ids[i]);
        }
      }
    });
}

bool AreNear(vtkPolyData* path, vtkIdType a, vtkIdType b, double near)
{
  double first[3];
  double second[3];
  path->GetPoint(a, first);
  path->GetPoint(b, second);
  return std::equal(
    first, first + 3, second, [near](double x, double y) { return std::abs(x - y) <= near; });
}

/** Whether the only line cell goes through all points in the order in which they are stored. */
bool IsInOrder(vtkPolyData* path)
{
  bool isInOrder = path->GetNumberOfLines() == 1;
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      isInOrder = isInOrder && size == path->GetNumberOfPoints();
      for (vtkIdType i = 0; isInOrder && i < size; ++i)
      {
        isInOrder = ids[i] == i;
      }
    });
  return isInOrder;
}

} // namespace

void DividedPoints::Append(const vtkIdType* ids, vtkIdType count)
{
  if (this->Points.empty())
  {
    vtkIdType same = 0;
    while (same < count && ids[same] == this->Count + same)
    {
      ++same;
    }
    if (same == count)
    {
      this->Count += count; // most polydata number their points in order, and need no list
      return;
    }
    this->Points.resize(static_cast<std::size_t>(this->Count));
    std::iota(this->Points.begin(), this->Points.end(), vtkIdType(0));
  }
  this->Points.insert(this->Points.end(), ids, ids + count);
  this->Count += count;
}

bool TipPathLines::IsOfSegments() const
{
  vtkIdType longest = 0;
  ForEachLine(
    this->Path, [&](vtkIdType size, const vtkIdType*) { longest = std::max(longest, size); });
  return longest == 2;
}

bool TipPathLines::IsOne() const
{
  return this->Path->GetNumberOfLines() <= 1 || (this->IsOfSegments() && this->CountStrokes() <= 1);
}

bool TipPathLines::Divide(DividedPoints& divided, std::string& error) const
{
  vtkPolyData* const path = this->Path;
  const bool isOfSegments = this->IsOfSegments();
  const double near = isOfSegments && path->GetNumberOfPoints() > 0 ? FindRounding(path) : 0.0;
  divided = {};
  vtkIdType line = 0;
  bool isAfterSegment = false;
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        if ((ids[i] < 0 || ids[i] >= path->GetNumberOfPoints()) && error.empty())
        {
          error = "Line " + std::to_string(line) + " of the tip path, on input port 1, has point " +
            std::to_string(ids[i]) + ", and there are " +
            std::to_string(path->GetNumberOfPoints()) +
            " points. Make the line of points that exist.";
        }
      }
      ++line;
      if (!error.empty())
      {
        return;
      }
      const bool isSegment = isOfSegments && size == 2;
      const bool goesOn =
        isSegment && isAfterSegment && AreNear(path, divided.GetLast(), ids[0], near);
      if (!goesOn)
      {
        divided.Begins.push_back(divided.Count);
      }
      // A point that two segments share is one tick.
      const vtkIdType known = goesOn && divided.GetLast() == ids[0] ? 1 : 0;
      divided.Append(ids + known, size - known);
      isAfterSegment = isSegment;
    });
  divided.Begins.push_back(divided.Count);
  return error.empty();
}

std::pair<long long, long long> TipPathLines::FindLeap() const
{
  vtkPolyData* const path = this->Path;
  if (IsInOrder(path))
  {
    return { -1, -1 };
  }
  // Points of cells are numbered from 1, in the order in which they are stored.
  std::vector<vtkIdType> number(static_cast<std::size_t>(path->GetNumberOfPoints()), 0);
  ForEachEdge(path, [&number](vtkIdType a, vtkIdType b) { number[a] = number[b] = 1; });
  vtkIdType count = 0;
  for (vtkIdType& one : number)
  {
    one = one != 0 ? ++count : 0;
  }
  std::vector<bool> isJoined(static_cast<std::size_t>(count) + 1, false); // to the next point
  ForEachEdge(path,
    [&](vtkIdType a, vtkIdType b)
    {
      if (std::abs(number[a] - number[b]) == 1)
      {
        isJoined[std::min(number[a], number[b])] = true;
      }
    });
  const double near = count > 0 ? FindRounding(path) : 0.0;
  vtkIdType last = -1;
  for (vtkIdType point = 0; point < path->GetNumberOfPoints(); ++point)
  {
    if (number[point] == 0)
    {
      continue;
    }
    if (last >= 0 && !isJoined[number[last]])
    {
      if (!AreNear(path, last, point, near))
      {
        return { last, point };
      }
    }
    last = point;
  }
  return { -1, -1 };
}

std::size_t TipPathLines::CountStrokes() const
{
  vtkPolyData* const path = this->Path;
  // Cell i begins at Ends[2 i] and ends at Ends[2 i + 1].
  std::vector<std::array<double, 3>> ends;
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* points)
    {
      const bool isLine = size > 1 && std::min(points[0], points[size - 1]) >= 0 &&
        std::max(points[0], points[size - 1]) < path->GetNumberOfPoints();
      for (vtkIdType i = 0; isLine && i < 2; ++i)
      {
        ends.emplace_back();
        path->GetPoint(points[i * (size - 1)], ends.back().data());
      }
    });
  if (ends.size() <= 2)
  {
    return ends.size() / 2;
  }

  // Ends meet if they are equal. If a cell continues the one before, rounding may separate their
  // ends.
  const double near = FindRounding(path);
  Junctions junctions(ends.size());
  std::map<std::array<double, 3>, std::size_t> places;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    junctions.Join(i, places.emplace(ends[i], i).first->second);
    if (i > 0 && i % 2 == 0 &&
      std::equal(ends[i].begin(), ends[i].end(), ends[i - 1].begin(),
        [near](double a, double b) { return std::abs(a - b) <= near; }))
    {
      junctions.Join(i, i - 1);
    }
  }

  // Connected cells are one line if at most two of their junctions have an odd number of ends
  // (Euler); otherwise each two of these junctions need a line.
  std::map<std::size_t, std::size_t> endsAt;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    ++endsAt[junctions.Find(i)];
  }
  Junctions pieces = junctions;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    pieces.Join(i, i + 1);
  }
  std::map<std::size_t, std::size_t> oddIn;
  for (const auto& [junction, count] : endsAt)
  {
    oddIn[pieces.Find(junction)] += count % 2;
  }
  return std::accumulate(oddIn.begin(), oddIn.end(), std::size_t(0),
    [](std::size_t sum, const auto& piece)
    { return sum + std::max<std::size_t>(1, piece.second / 2); });
}

} // namespace VolumeHaptics
