// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/ToolFile.h"

#include "Applications/Explorer/Exploration/ShapeFile.h"
#include "VTK/Reading/InputError.h"

#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"

namespace
{
bool HasOrigin(const double* bounds)
{
  return bounds[0] <= 0.0 && bounds[1] >= 0.0 && bounds[2] <= 0.0 && bounds[3] >= 0.0 &&
    bounds[4] <= 0.0 && bounds[5] >= 0.0;
}

/// Orients the triangles outwards, because files differ in the order of corners.
vtkSmartPointer<vtkPolyData> TurnOutwards(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> turned;
  turned->SetInputData(surface);
  turned->SplittingOff();
  turned->ConsistencyOn();
  turned->AutoOrientNormalsOn();
  turned->ComputePointNormalsOff();
  turned->ComputeCellNormalsOn();
  turned->Update();
  return turned->GetOutput();
}

vtkSmartPointer<vtkPolyData> MergeCorners(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(surface);
  merged->ConvertPolysToLinesOff();
  merged->Update();
  return merged->GetOutput();
}

/// Counts the edges that belong to only one triangle.
vtkIdType CountOpenEdges(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}
} // namespace

namespace Explore
{
bool IsToolFile(const std::string& name)
{
  const std::string ending = GetEnding(name);
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".vtp";
}

vtkSmartPointer<vtkPolyData> ReadToolFile(const std::string& name)
{
  const char* const cure = "use the closed surface of a tool";
  vtkSmartPointer<vtkPolyData> surface = ReadShapeFile("--tool", name, cure);
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw InputError("--tool " + name, "it has no triangles", cure);
  }
  surface = MergeCorners(surface);
  if (const vtkIdType open = CountOpenEdges(surface))
  {
    throw InputError("--tool " + name,
      "it is open: " + std::to_string(open) + " edges have a triangle on one side only", cure);
  }
  surface = TurnOutwards(surface);
  double bounds[6];
  surface->GetBounds(bounds);
  if (!HasOrigin(bounds))
  {
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double x[3];
      surface->GetPoint(i, x);
      for (int a = 0; a < 3; ++a)
      {
        x[a] -= 0.5 * (bounds[2 * a] + bounds[2 * a + 1]);
      }
      surface->GetPoints()->SetPoint(i, x);
    }
    surface->GetPoints()->Modified();
  }
  return surface;
}
} // namespace Explore
