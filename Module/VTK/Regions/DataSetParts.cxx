// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/DataSetParts.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double LeastAlongEdge = 24.0; ///< samples, because kernels need some along each edge
constexpr double MostAlongEdge = 1e6;   ///< samples

void GetEdges(const vtkBoundingBox& box, double edges[3])
{
  std::fill(edges, edges + 3, 0.0);
  if (box.IsValid())
  {
    box.GetLengths(edges);
  }
}

} // namespace

std::vector<vtkDataSet*> CollectParts(vtkDataObject* data)
{
  std::vector<vtkDataSet*> parts;
  const auto add = [&](vtkDataObject* part)
  {
    auto* const set = vtkDataSet::SafeDownCast(part);
    if (set && set->GetNumberOfCells() > 0)
    {
      parts.push_back(set);
    }
  };
  add(data);
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  return parts;
}

double CountCells(const std::vector<vtkDataSet*>& parts)
{
  double cells = 0.0;
  for (vtkDataSet* const part : parts)
  {
    cells += static_cast<double>(part->GetNumberOfCells());
  }
  return cells;
}

vtkBoundingBox ComputeBox(const std::vector<vtkDataSet*>& parts)
{
  vtkBoundingBox box;
  for (vtkDataSet* const part : parts)
  {
    box.AddBounds(part->GetBounds());
  }
  return box;
}

double ComputeSampleSpacing(const vtkBoundingBox& box, double cells)
{
  double edges[3];
  GetEdges(box, edges);
  return std::min(std::cbrt(edges[0] * edges[1] * edges[2] / cells),
    std::min({ edges[0], edges[1], edges[2] }) / LeastAlongEdge);
}

bool PlaceGrid(const vtkBoundingBox& box, double spacing, SamplingGrid& grid)
{
  double edges[3];
  GetEdges(box, edges);
  grid.Spacing = spacing;
  for (int a = 0; a < 3; ++a)
  {
    const double count = std::floor(edges[a] / spacing * (1.0 + 1e-12)) + 1.0;
    if (!(edges[a] > 0.0) || !std::isfinite(count) || count > MostAlongEdge)
    {
      return false;
    }
    grid.Dimensions[a] = static_cast<int>(count);
    grid.Origin[a] = box.GetMinPoint()[a] + 0.5 * (edges[a] - (count - 1.0) * spacing);
  }
  return true;
}

} // namespace VolumeHaptics
