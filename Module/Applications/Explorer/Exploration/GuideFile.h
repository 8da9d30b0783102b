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
/// Checks that a name has an ending that --guide accepts: a shape (.vtp, .vtk, .stl, .ply, .obj),
/// or measurements (.csv, .mrk.json, .vtp). Otherwise throws InputError.
void CheckGuideFile(const std::string& name);

/// Makes the mode that guides the hand along the lines of a file, or keeps it on the file's
/// polygons, in the coordinates of an image. A file of measurements guides along its paths. Throws
/// InputError, also if the whole shape is outside the image.
vtkSmartPointer<vtkHapticGuideMode> ReadGuideFile(const std::string& name, vtkImageData* image);
} // namespace Explore

#endif
