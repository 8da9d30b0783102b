// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticShapedTool.h"

#include "VTK/Tools/HapticToolSettings.h"

//------------------------------------------------------------------------------
vtkHapticShapedTool::vtkHapticShapedTool(double contactArea)
  : ContactArea(contactArea)
{
}

//------------------------------------------------------------------------------
vtkHapticShapedTool::~vtkHapticShapedTool() = default;

//------------------------------------------------------------------------------
void vtkHapticShapedTool::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::ShapedToolSettings);
}
