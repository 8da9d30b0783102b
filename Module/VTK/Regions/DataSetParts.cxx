// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/DataSetParts.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace VolumeHaptics
{
namespace
{

constexpr double LeastAlongEdge = 24.0; ///< samples, so that kernels have room along each edge
constexpr double MostAlongEdge = 1e6;   ///< samples

void GetEdges(const vtkBoundingBox& box, double edges[3])
{
  std::fill(edges, edges + 3, 0.0);
  if (box.IsValid())
  {
    box.GetLengths(edges);
  }
}

bool HasFaces(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 90)
  return grid->GetFaces() != nullptr;
#else
  return grid->GetPolyhedronFaces() != nullptr;
#endif
}

vtkDataArray* GetKinds(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypesArray();
#else
  return grid->GetCellTypes();
#endif
}

bool HasPointsOf(vtkCellArray* cells, vtkIdType points)
{
  double range[2] = { 0.0, -1.0 };
  if (cells && cells->IsValid() && cells->GetNumberOfConnectivityIds() > 0)
  {
    cells->GetConnectivityArray()->GetRange(range, 0);
  }
  return (!cells || cells->IsValid()) && range[0] >= 0.0 && range[1] < static_cast<double>(points);
}

/** Returns whether all polyhedra have faces, with corners that exist. */
bool HasWholeFaces(vtkUnstructuredGrid* grid)
{
  const vtkIdType count = HasFaces(grid) ? grid->GetNumberOfCells() : 0;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 90)
  vtkIdTypeArray* const faces = grid->GetFaces();
  vtkIdTypeArray* const locations = grid->GetFaceLocations();
  bool isThere = count == 0 || (locations && locations->GetNumberOfValues() >= count);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; isThere && i < count; ++i)
  {
    vtkIdType at = locations->GetValue(i);
    const auto next = [&]
    { return at >= 0 && at < faces->GetNumberOfValues() ? faces->GetValue(at++) : -1; };
    const bool isPolyhedron = grid->GetCellType(i) == VTK_POLYHEDRON;
    grid->GetCells()->GetCellAtId(i, corners);
    vtkIdType left = isPolyhedron ? next() : 0;
    for (isThere = left >= 0; isThere && left > 0; --left)
    {
      vtkIdType ids = next();
      for (isThere = ids >= 0; isThere && ids > 0; --ids)
      {
        isThere = corners->IsId(next()) >= 0;
      }
    }
  }
  return isThere;
#else
  vtkCellArray* const faces = grid->GetPolyhedronFaces();
  vtkCellArray* const locations = grid->GetPolyhedronFaceLocations();
  return count == 0 ||
    (locations && locations->GetNumberOfCells() >= count &&
      HasPointsOf(faces, grid->GetNumberOfPoints()) &&
      HasPointsOf(locations, faces->GetNumberOfCells()));
#endif
}

/** Returns whether all cells have the number of corners that their types require. */
bool HasCorners(vtkUnstructuredGrid* grid)
{
  std::map<int, vtkIdType> needed;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const int kind = grid->GetCellType(i);
    const auto found = needed.find(kind);
    if (found == needed.end())
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(kind));
      needed[kind] = cell ? cell->GetNumberOfPoints() : 0; // 0: the type has any number of corners
      --i;
    }
    else if (grid->GetCells()->GetCellSize(i) < found->second)
    {
      return false;
    }
  }
  return true;
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

bool LackFaces(const std::vector<vtkDataSet*>& parts)
{
  return std::any_of(parts.begin(), parts.end(),
    [](vtkDataSet* part)
    {
      auto* const grid = vtkUnstructuredGrid::SafeDownCast(part);
      vtkDataArray* const types = grid ? GetKinds(grid) : nullptr;
      if (!types || HasFaces(grid))
      {
        return false;
      }
      for (vtkIdType i = 0; i < types->GetNumberOfTuples(); ++i)
      {
        if (types->GetComponent(i, 0) == VTK_POLYHEDRON)
        {
          return true;
        }
      }
      return false;
    });
}

std::string DetectFalseCells(const std::vector<vtkDataSet*>& parts)
{
  if (LackFaces(parts))
  {
    return "has polyhedra without faces";
  }
  for (vtkDataSet* const part : parts)
  {
    const vtkIdType points = part->GetNumberOfPoints();
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(part);
    auto* const boxes = vtkExplicitStructuredGrid::SafeDownCast(part);
    auto* const shape = vtkPolyData::SafeDownCast(part);
    vtkCellArray* const cells = grid ? grid->GetCells() : boxes ? boxes->GetCells() : nullptr;
    const vtkIdType count = part->GetNumberOfCells();
    vtkDataArray* const types = grid ? GetKinds(grid) : nullptr;
    if ((grid && (!types || types->GetNumberOfValues() < count)) ||
      (boxes && (!cells || cells->GetNumberOfCells() < count)))
    {
      return "has fewer cells than it tells";
    }
    const bool areThere = cells ? HasPointsOf(cells, points)
                                : !shape ||
        (HasPointsOf(shape->GetVerts(), points) && HasPointsOf(shape->GetLines(), points) &&
          HasPointsOf(shape->GetPolys(), points) && HasPointsOf(shape->GetStrips(), points));
    if (!areThere)
    {
      return "has a cell at a point that does not exist";
    }
    constexpr vtkIdType corners = 8; // of a box
    if (boxes ? cells->IsHomogeneous() < corners : grid && !HasCorners(grid))
    {
      return "has a cell with fewer corners than its kind";
    }
    if (grid && !HasWholeFaces(grid))
    {
      return "has a polyhedron with faces that do not exist";
    }
  }
  return {};
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
