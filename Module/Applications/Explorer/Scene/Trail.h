// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Trail_h
#define Explore_Trail_h

#include "vtkPolyData.h"

class vtkRenderer;

namespace Explore
{
/// Adds a tube along the proxy's path, coloured by the magnitude of the force, and its scalar bar.
/// `overlay`, drawn over the renderer's picture, gets a faint copy: it shows the hidden parts of
/// the tube.
void AddTrail(vtkRenderer* renderer, vtkRenderer* overlay, vtkPolyData* trace,
  double metersPerWorldUnit, int pictureHeight);
} // namespace Explore

#endif
