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
/// Returns a file name's extension in lower case, such as ".stl".
std::string GetEnding(const std::string& name);

/// Reads points, lines and polygons from a .stl, .ply, .obj, .vtk or .vtp file. Returns null, with
/// the reason in `error`, if the file can't be read, if it is shorter than its header declares, or
/// if a cell refers to a point that does not exist.
vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& name, std::string& error);

/// Reads a surface inside the reader process, which a damaged file may crash. Returns the bytes
/// that ReadPolyData() unpacks.
std::string PackSurface(const std::string& name);

///@{
/// Pack data with their numeric point and cell arrays, whose names and roles (such as active
/// scalars) are preserved, and an image's field data; and unpack them. Unpacking checks that arrays
/// and cells fit the data, and throws std::runtime_error for every fault.
void PackImage(vtkImageData* image, VolumeHaptics::BytePacker& packer);
void PackPolyData(vtkPolyData* shape, VolumeHaptics::BytePacker& packer);
vtkSmartPointer<vtkImageData> UnpackImage(VolumeHaptics::ByteUnpacker& unpacker);
vtkSmartPointer<vtkPolyData> UnpackPolyData(VolumeHaptics::ByteUnpacker& unpacker);
///@}
} // namespace Explore

#endif
