// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/HeldTool.h"

#include "VTK/Tools/ToolKind.h"

#include "vtkHapticDevice.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{

vtkHapticTool* GetHeldTool(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  return filter ? filter->GetTool() : nullptr;
}

bool IsTurnable(vtkHapticTool* tool)
{
  const ToolKind* const kind = FindToolKind(tool);
  return kind && kind->IsTurnable();
}

double ComputeToolReach(vtkHapticTool* tool)
{
  const ToolKind* const kind = FindToolKind(tool);
  return kind ? kind->ComputeReach(tool) : 0.0;
}

} // namespace VolumeHaptics
