// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticTool.h"

#include "VTK/Tools/HapticToolKinds.h"

//------------------------------------------------------------------------------
vtkHapticTool::vtkHapticTool() = default;
vtkHapticTool::~vtkHapticTool() = default;

//------------------------------------------------------------------------------
std::string vtkHapticTool::GetText()
{
  return VolumeHaptics::GetToolText(this);
}

//------------------------------------------------------------------------------
void vtkHapticTool::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << this->GetText() << "\n";
}
