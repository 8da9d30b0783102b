// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_GuideFile_h
#define Explore_GuideFile_h

#include "vtkHapticGuideMode.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace Explore
{
/// Throws InputError unless a name has the ending of a file that --guide accepts: a shape (.vtp,
/// .vtk, .stl, .ply, .obj), or measurements (.csv, .mrk.json, .vtp).
void CheckGuideFile(const std::string& name);

/// Makes the mode that leads the hand along the lines of a file, or holds it on the file's
/// polygons, in the coordinates of an image. A file of measurements leads along its paths. Throws
/// InputError, also if all of the shape is outside the image.
vtkSmartPointer<vtkHapticGuideMode> ReadGuideFile(const std::string& name, vtkImageData* image);
} // namespace Explore

#endif
