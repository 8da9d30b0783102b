// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/ShapeFile.h"

#include "VTK/Reading/InputError.h"

#include "vtksys/SystemTools.hxx"

namespace Explore
{
vtkSmartPointer<vtkPolyData> ReadShapeFile(
  const std::string& option, const std::string& name, const std::string& cure)
{
  if (!vtksys::SystemTools::FileExists(name, true))
  {
    throw InputError(option + " " + name, "there is no such file", "check its path");
  }
  std::string error;
  vtkSmartPointer<vtkPolyData> shape = ReadPolyData(name, error);
  if (!shape)
  {
    throw InputError(option + " " + name, "it can't be read: " + error, cure);
  }
  return shape;
}
} // namespace Explore
