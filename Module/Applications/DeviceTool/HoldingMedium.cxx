// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/HoldingMedium.h"

#include "Applications/DeviceTool/WorkspaceVolume.h"

#include <vtkHapticProperty.h>
#include <vtkVolumeHapticsFilter.h>

namespace
{

constexpr double Strength = 1000.0;    // N, much more than any device has
constexpr double MediumSpacing = 40.0; // mm
constexpr int MediumSteps = 6;         // beyond every device's workspace

} // namespace

void MakeHoldingMedium(vtkVolumeHapticsFilter* filter, double stiffness)
{
  TouchField(filter, MediumSpacing, MediumSteps, [](const double*) { return 0.0; });
  vtkHapticProperty* const property = filter->GetProperty();
  SetEverywhere(property->GetStiffness(), stiffness);
  SetEverywhere(property->GetFriction(), 0.0);
  SetEverywhere(property->GetViscosity(), Strength);
  SetEverywhere(property->GetSurfaceStrength(), 0.0);
}
