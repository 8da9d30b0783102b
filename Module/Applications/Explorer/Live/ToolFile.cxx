// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/ToolFile.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"

#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPoints.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include "vtksys/SystemTools.hxx"

namespace
{
std::string FindEnding(const std::string& name)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::string& name)
{
  vtkNew<Reader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& name)
{
  const std::string ending = FindEnding(name);
  if (ending == ".stl")
  {
    return ReadWith<vtkSTLReader>(name);
  }
  if (ending == ".ply")
  {
    return ReadWith<vtkPLYReader>(name);
  }
  return ending == ".obj" ? ReadWith<vtkOBJReader>(name) : ReadWith<vtkXMLPolyDataReader>(name);
}

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
  if (!vtksys::SystemTools::FileExists(name, true))
  {
    throw InputError("--tool " + name, "there is no such file", "name one that is there");
  }
  const MessageCapture capture;
  const vtkSmartPointer<vtkPolyData> surface = ReadSurface(name);
  const std::string error = capture.FirstError();
  if (!error.empty() || surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
  {
    throw InputError("--tool " + name,
      error.empty() ? "it has no triangles" : "it can't be read: " + error,
      "take the closed surface of a tool");
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
