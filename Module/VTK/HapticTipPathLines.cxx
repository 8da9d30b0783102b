// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of HapticTipPath that tells one line, in however many cells, from several.
#include "HapticTipPath.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace VolumeHaptics
{
namespace
{

/** Places where cells of the path begin or end; two that are one place count as one. */
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

} // namespace

std::size_t CountLines(vtkPolyData* path)
{
  // Cell i begins at Ends[2 i] and ends at Ends[2 i + 1].
  std::vector<std::array<double, 3>> ends;
  const auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(path->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCurrentCell(size, points);
    const bool isLine = size > 1 && std::min(points[0], points[size - 1]) >= 0 &&
      std::max(points[0], points[size - 1]) < path->GetNumberOfPoints();
    if (isLine)
    {
      for (const vtkIdType point : { points[0], points[size - 1] })
      {
        ends.emplace_back();
        path->GetPoint(point, ends.back().data());
      }
    }
  }
  if (ends.size() <= 2)
  {
    return ends.size() / 2;
  }

  // Ends meet where they are equal. What continues the cell before may also miss its end by rounding.
  double bounds[6];
  path->GetPoints()->GetBounds(bounds);
  constexpr double rounding = 1e-6;
  const double near =
    rounding * std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
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

  // Cells that hang together can be drawn in one go when at most two of their junctions have an odd number of ends
  // (Euler), and otherwise take a line for every two of these.
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
