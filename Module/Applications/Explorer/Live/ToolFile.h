// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ToolFile_h
#define Explore_ToolFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// Returns whether a file name has the ending of a surface: .stl, .ply, .obj or .vtp.
bool IsToolFile(const std::string& name);

/// Reads the surface of a tool. Lengths in the file are assumed to be in the volume's unit. If the
/// surface's bounding box does not contain the origin, moves the centre of the box to the origin.
/// Flips triangles that face inwards. Throws InputError, also for an open surface.
vtkSmartPointer<vtkPolyData> ReadToolFile(const std::string& name);
} // namespace Explore

#endif
