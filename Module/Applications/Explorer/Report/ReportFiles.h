// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ReportFiles_h
#define Explore_ReportFiles_h

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <string>

class vtkRenderWindow;

namespace Explore
{
/// Creates the folder. Throws InputError on failure.
void MakeFolder(const std::string& folder);

/// Writes the whole trace as VTK polygonal data (.vtp).
void WriteTrace(vtkPolyData* trace, const std::string& file);

/// Writes a table with a row for each tick and a column for each component of an array. The header
/// contains the units.
void WriteTable(vtkPolyData* trace, const std::string& file);

/// Writes an image in VTK's XML format, with all of its arrays, uncompressed.
void WriteImage(vtkImageData* image, const std::string& file);

/// Writes the last frame of the window to a PNG file.
void WritePicture(vtkRenderWindow* window, const std::string& file);

void WriteText(const std::string& text, const std::string& file);
} // namespace Explore

#endif
