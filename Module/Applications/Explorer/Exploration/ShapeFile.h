// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ShapeFile_h
#define Explore_ShapeFile_h

#include "VTK/Reading/ForeignData.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// Reads a surface like ReadPolyData, but throws InputError on failure. The error begins with the
/// option that names the file, and ends with the cure.
vtkSmartPointer<vtkPolyData> ReadShapeFile(
  const std::string& option, const std::string& name, const std::string& cure);
} // namespace Explore

#endif
