// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/GuideFile.h"

#include "Applications/Explorer/Exploration/ShapeFile.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkHapticMeasurements.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>

namespace
{
using Explore::InputError;
const std::string Option = "--guide";

bool IsOneOf(const std::string& ending, std::initializer_list<const char*> endings)
{
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Returns the paths of measurements, each as one line. Returns null for a .vtp without
/// measurements.
vtkSmartPointer<vtkPolyData> ReadMeasuredPaths(const std::string& name)
{
  vtkNew<vtkHapticMeasurements> list;
  const Explore::MessageCapture capture;
  if (!vtksys::SystemTools::FileExists(name, true) || !list->ReadFile(name.c_str()))
  {
    if (IsOneOf(Explore::GetEnding(name), { ".vtp" }))
    {
      return nullptr;
    }
    throw InputError(Option + " " + name, "its measurements can't be read: " + capture.FirstError(),
      "give a file saved with Ctrl+S in the window");
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < list->GetNumberOfMeasurements(); ++i)
  {
    const bool isPath = list->GetKind(i) == vtkHapticMeasurements::PATH;
    const vtkIdType count = isPath ? list->GetNumberOfPoints(i) : 0;
    if (count > 1)
    {
      lines->InsertNextCell(static_cast<int>(count));
    }
    for (vtkIdType k = 0; count > 1 && k < count; ++k)
    {
      double x[3];
      list->GetPoint(i, k, x);
      lines->InsertCellPoint(points->InsertNextPoint(x));
    }
  }
  if (lines->GetNumberOfCells() == 0)
  {
    throw InputError(
      Option + " " + name, "its measurements have no path", "measure one with key 4 in the window");
  }
  auto path = vtkSmartPointer<vtkPolyData>::New();
  path->SetPoints(points);
  path->SetLines(lines);
  return path;
}

vtkSmartPointer<vtkPolyData> ReadGuide(const std::string& name)
{
  if (IsOneOf(Explore::GetEnding(name), { ".csv", ".json", ".vtp" }))
  {
    if (vtkSmartPointer<vtkPolyData> paths = ReadMeasuredPaths(name))
    {
      return paths;
    }
  }
  return Explore::ReadShapeFile(Option, name, "correct it or choose another file");
}
} // namespace

namespace Explore
{
void CheckGuideFile(const std::string& name)
{
  if (!IsOneOf(GetEnding(name), { ".vtp", ".vtk", ".stl", ".ply", ".obj", ".csv", ".json" }))
  {
    throw InputError(Option + " '" + name + "'", "has an unknown extension",
      "use lines or a surface that end in .vtp, .vtk, .stl, .ply or .obj, or measurements "
      "(.csv, .mrk.json, .vtp), whose paths lead");
  }
}

vtkSmartPointer<vtkHapticGuideMode> ReadGuideFile(const std::string& name, vtkImageData* image)
{
  const vtkSmartPointer<vtkPolyData> shape = ReadGuide(name);
  const vtkIdType polygons = shape->GetNumberOfPolys() + shape->GetNumberOfStrips();
  if (shape->GetNumberOfPoints() < 2)
  {
    throw InputError(Option + " " + name, "it has no line and no polygons",
      "use a polyline, or the triangles of a surface");
  }
  double bounds[6];
  shape->GetBounds(bounds);
  const vtkBoundingBox box(bounds);
  image->GetBounds(bounds);
  if (!box.Intersects(vtkBoundingBox(bounds)))
  {
    throw InputError(Option + " " + name, "it lies entirely outside the volume",
      "give it the volume's coordinates and units; the summary of --pictures has its size");
  }
  auto guide = vtkSmartPointer<vtkHapticGuideMode>::New();
  const bool hasLines = shape->GetNumberOfLines() > 0;
  if (hasLines || polygons == 0)
  {
    guide->SetPath(shape);
  }
  else
  {
    guide->SetSurface(shape);
  }
  return guide;
}
} // namespace Explore
