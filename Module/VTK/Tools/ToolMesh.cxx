// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ToolMesh.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace VolumeHaptics
{
namespace
{

bool Refuse(std::string& error, const std::string& text)
{
  error = "The mesh of the tool " + text;
  return false;
}

/** Returns the triangles of a mesh with coinciding corners merged. */
vtkSmartPointer<vtkPolyData> MergeCorners(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->SetTolerance(0.0);
  clean->ConvertPolysToLinesOff();
  clean->ConvertLinesToPointsOff();
  clean->Update();
  return clean->GetOutput();
}

template <typename Function>
void ForEachTriangle(vtkPolyData* mesh, Function&& visit)
{
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    if (count == 3)
    {
      visit(ids);
    }
  }
}

Vector3 PointAt(vtkPolyData* mesh, vtkIdType id)
{
  double x[3];
  mesh->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

/**
 * Checks that the surface is closed: each edge must belong to two triangles that run along it in
 * opposite directions. If an edge belongs to several such pairs, parts of the surface touch one
 * another there.
 */
bool CheckEdges(vtkPolyData* mesh, std::string& error)
{
  struct Run
  {
    std::pair<vtkIdType, vtkIdType> Edge; // the lower id first
    int Direction;
  };
  std::vector<Run> runs;
  runs.reserve(3 * static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  ForEachTriangle(mesh,
    [&](const vtkIdType* ids)
    {
      for (int i = 0; i < 3; ++i)
      {
        const vtkIdType from = ids[i];
        const vtkIdType to = ids[(i + 1) % 3];
        runs.push_back({ { std::min(from, to), std::max(from, to) }, from < to ? 1 : -1 });
      }
    });
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.Edge < b.Edge; });
  std::size_t edges = 0;
  std::size_t open = 0;
  std::size_t crossed = 0;
  for (std::size_t i = 0; i < runs.size(); ++edges)
  {
    const std::size_t begin = i;
    int sum = 0;
    for (; i < runs.size() && runs[i].Edge == runs[begin].Edge; ++i)
    {
      sum += runs[i].Direction;
    }
    const bool isOdd = (i - begin) % 2 != 0;
    open += isOdd ? 1 : 0;
    crossed += !isOdd && sum != 0 ? 1 : 0;
  }
  if (open > 0)
  {
    return Refuse(error,
      "is not closed: " + std::to_string(open) + " of its " + std::to_string(edges) +
        " edges belong to one triangle only. Close it, for example with vtkFillHolesFilter "
        "and then vtkPolyDataNormals, or merge points that lie nearly at the same place with "
        "vtkCleanPolyData and SetTolerance().");
  }
  if (crossed > 0)
  {
    return Refuse(error,
      "has neighbours that face opposite sides, at " + std::to_string(crossed) + " of its " +
        std::to_string(edges) +
        " edges. Turn them to one side with vtkPolyDataNormals and ConsistencyOn().");
  }
  return true;
}

/** Checks the ids of points, because VTK's filters would read beyond the array for a wrong id. */
bool CheckIds(vtkCellArray* cells, vtkIdType points, std::string& error)
{
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    const auto* const missing =
      std::find_if(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; });
    if (missing != ids + count)
    {
      return Refuse(error,
        "has a polygon with the point " + std::to_string(*missing) + ", but only " +
          std::to_string(points) + " points. Correct the mesh.");
    }
  }
  return true;
}

bool CheckPoints(vtkPolyData* mesh, std::string& error)
{
  if (!mesh || mesh->GetNumberOfPoints() == 0 ||
    mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    return Refuse(error, "has no polygons. Give a closed surface, such as that of an STL file.");
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (!IsFinite(PointAt(mesh, i)))
    {
      return Refuse(error,
        "has a point that is not finite, number " + std::to_string(i) + ". Correct the mesh.");
    }
  }
  return CheckIds(mesh->GetPolys(), mesh->GetNumberOfPoints(), error) &&
    CheckIds(mesh->GetStrips(), mesh->GetNumberOfPoints(), error);
}

} // namespace

bool ReadToolMesh(vtkPolyData* mesh, std::vector<ToolTriangle>& triangles, std::string& error)
{
  triangles.clear();
  if (!CheckPoints(mesh, error))
  {
    return false;
  }
  const vtkSmartPointer<vtkPolyData> clean = MergeCorners(mesh);
  if (!CheckEdges(clean, error))
  {
    return false;
  }
  double bounds[6];
  clean->GetBounds(bounds);
  const Vector3 middle =
    0.5 * Vector3{ bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5] };
  double volume = 0.0; // six times the volume, by the divergence theorem
  ForEachTriangle(clean,
    [&](const vtkIdType* ids)
    {
      ToolTriangle triangle;
      for (int i = 0; i < 3; ++i)
      {
        triangle.Corner[i] = PointAt(clean, ids[i]);
      }
      const Vector3& from = triangle.Corner[0];
      const Vector3 across = Cross(triangle.Corner[1] - from, triangle.Corner[2] - from);
      const double twice = Norm(across);
      volume += Dot(across, from - middle);
      triangle.Area = 0.5 * twice;
      if (triangle.Area > 0.0 && std::isfinite(triangle.Area))
      {
        triangle.Normal = (1.0 / twice) * across;
        triangles.push_back(triangle);
      }
    });
  if (triangles.empty())
  {
    return Refuse(error, "has no triangle with an area. Give it a surface with an extent.");
  }
  if (!(volume > 0.0))
  {
    triangles.clear();
    return Refuse(error,
      "is inside out: its triangles face inwards. Turn them with vtkReverseSense and "
      "ReverseCellsOn().");
  }
  return true;
}

} // namespace VolumeHaptics
