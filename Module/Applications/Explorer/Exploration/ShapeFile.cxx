// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/ShapeFile.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"

#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

#include "vtksys/SystemTools.hxx"

namespace
{
template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::string& name)
{
  vtkNew<Reader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadShape(const std::string& name)
{
  const std::string ending = Explore::FindEnding(name);
  if (ending == ".stl")
  {
    return ReadWith<vtkSTLReader>(name);
  }
  if (ending == ".ply")
  {
    return ReadWith<vtkPLYReader>(name);
  }
  if (ending == ".vtk")
  {
    return ReadWith<vtkPolyDataReader>(name);
  }
  return ending == ".obj" ? ReadWith<vtkOBJReader>(name) : ReadWith<vtkXMLPolyDataReader>(name);
}
} // namespace

namespace Explore
{
std::string FindEnding(const std::string& name)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
}

vtkSmartPointer<vtkPolyData> ReadShapeFile(
  const std::string& option, const std::string& name, const std::string& cure)
{
  if (!vtksys::SystemTools::FileExists(name, true))
  {
    throw InputError(option + " " + name, "there is no such file", "name one that is there");
  }
  const MessageCapture capture;
  vtkSmartPointer<vtkPolyData> shape = ReadShape(name);
  const std::string error = capture.FirstError();
  if (!error.empty())
  {
    throw InputError(option + " " + name, "it can't be read: " + error, cure);
  }
  return shape;
}
} // namespace Explore
