// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_GridOutline_h
#define Explore_GridOutline_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;

namespace Explore
{
/// Lines that show where the cells of a grid are: the sharp edges and the open ends of the surfaces
/// of its parts or, if there are no such lines, the box around all parts.
vtkSmartPointer<vtkPolyData> MakeGridOutline(const std::vector<vtkDataSet*>& parts);
} // namespace Explore

#endif
