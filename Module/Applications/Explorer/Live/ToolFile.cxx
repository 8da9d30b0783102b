// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/ToolFile.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Exploration/ShapeFile.h"

#include "vtkPoints.h"

namespace
{
bool HasOrigin(const double* bounds)
{
  return bounds[0] <= 0.0 && bounds[1] >= 0.0 && bounds[2] <= 0.0 && bounds[3] >= 0.0 &&
    bounds[4] <= 0.0 && bounds[5] >= 0.0;
}
} // namespace

namespace Explore
{
bool IsToolFile(const std::string& name)
{
  const std::string ending = FindEnding(name);
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".vtp";
}

vtkSmartPointer<vtkPolyData> ReadToolFile(const std::string& name)
{
  const char* const cure = "take the closed surface of a tool";
  vtkSmartPointer<vtkPolyData> surface = ReadShapeFile("--tool", name, cure);
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw InputError("--tool " + name, "it has no triangles", cure);
  }
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
