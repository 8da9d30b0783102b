// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Trail_h
#define Explore_Trail_h

#include "vtkPolyData.h"

class vtkRenderer;

namespace Explore
{
/// Adds a tube along the proxy's way, coloured by the magnitude of the force, and its scalar bar.
void AddTrail(
  vtkRenderer* renderer, vtkPolyData* trace, double metersPerWorldUnit, int pictureHeight);
}

#endif
