// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/GentleWall.h"

#include "Applications/DeviceTool/WorkspaceVolume.h"

#include <vtkHapticProperty.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeHapticsFilter.h>

namespace
{

constexpr double Stiffness = 200.0;       // N/m: the whole force after 5 mm
constexpr double SurfaceStrength = 100.0; // N, much more than the hand gets: it never falls through
constexpr double WallSpacing = 4.0;       // mm
constexpr int WallSteps = 50;             // beyond every device's workspace

} // namespace

void MakeGentleWall(vtkVolumeHapticsFilter* filter, int axis)
{
  // The values are mm into the wall.
  TouchField(
    filter, WallSpacing, WallSteps, [axis](const double* position) { return -position[axis]; });
  vtkHapticProperty* const property = filter->GetProperty();
  SetEverywhere(property->GetStiffness(), Stiffness);
  SetEverywhere(property->GetFriction(), 0.0);
  SetEverywhere(property->GetViscosity(), 0.0);
  SetEverywhere(property->GetDistinctness(), 1.0);
  property->GetSurfaceStrength()->RemoveAllPoints();
  property->GetSurfaceStrength()->AddPoint(0.0, 0.0);
  property->GetSurfaceStrength()->AddPoint(0.1, SurfaceStrength);
  property->SetSurfaceSideToHigher();
}
