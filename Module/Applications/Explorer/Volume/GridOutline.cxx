// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/GridOutline.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCleanPolyData.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkOutlineSource.h"

namespace
{
vtkSmartPointer<vtkPolyData> FindEdges(vtkDataSet* part)
{
  constexpr double sharp = 30.0; // degrees
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(part);
  // The faces of a structured grid do not share points.
  vtkNew<vtkCleanPolyData> join;
  join->SetInputConnection(surface->GetOutputPort());
  join->ToleranceIsAbsoluteOn();
  join->SetAbsoluteTolerance(0.0);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(join->GetOutputPort());
  edges->SetFeatureAngle(sharp);
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}
} // namespace

namespace Explore
{
vtkSmartPointer<vtkPolyData> MakeGridOutline(const std::vector<vtkDataSet*>& parts)
{
  vtkNew<vtkAppendPolyData> all;
  vtkBoundingBox box;
  vtkIdType lines = 0;
  for (vtkDataSet* const part : parts)
  {
    const vtkSmartPointer<vtkPolyData> edges = FindEdges(part);
    lines += edges->GetNumberOfLines();
    all->AddInputData(edges);
    box.AddBounds(part->GetBounds());
  }
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkOutlineSource> corners;
  corners->SetBounds(bounds);
  vtkAlgorithm* const source = lines > 0 ? static_cast<vtkAlgorithm*>(all) : corners;
  source->Update();
  return vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
}
} // namespace Explore
