// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ShapeFile_h
#define Explore_ShapeFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// Returns the ending of a file's name in lower case, such as ".stl".
std::string GetEnding(const std::string& name);

/// Reads points, lines and polygons of a file .stl, .ply, .obj, .vtk or .vtp. Returns null, with
/// the reason in `error`, if the file can't be read, if it is shorter than its header promises, or
/// if a cell has a point that does not exist.
vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& name, std::string& error);

/// Reads like ReadPolyData, but throws InputError, whose text begins with the option that names the
/// file and contains the cure.
vtkSmartPointer<vtkPolyData> ReadShapeFile(
  const std::string& option, const std::string& name, const std::string& cure);
} // namespace Explore

#endif
