// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ForeignData_h
#define Explore_ForeignData_h

#include "Core/Platform/PackedBytes.h"

#include "vtkImageData.h"
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

/// Reads a surface in the process that its reader may end; returns what ReadPolyData() unpacks.
std::string PackSurface(const std::string& name);

///@{
/// Pack data with their point and cell arrays of numbers, which keep their names and what they are
/// used for, and an image's field data, and unpack them. Unpacking checks that arrays and cells
/// belong to the data; every fault is a std::runtime_error.
void PackImage(vtkImageData* image, VolumeHaptics::BytePacker& packer);
void PackPolyData(vtkPolyData* shape, VolumeHaptics::BytePacker& packer);
vtkSmartPointer<vtkImageData> UnpackImage(VolumeHaptics::ByteUnpacker& unpacker);
vtkSmartPointer<vtkPolyData> UnpackPolyData(VolumeHaptics::ByteUnpacker& unpacker);
///@}
} // namespace Explore

#endif
