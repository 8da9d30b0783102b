// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticVectorFrontMode.h"

#include "VTK/Modes/HapticModeSettings.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticVectorFrontMode);

//------------------------------------------------------------------------------
vtkHapticVectorFrontMode::vtkHapticVectorFrontMode() = default;
vtkHapticVectorFrontMode::~vtkHapticVectorFrontMode() = default;

//------------------------------------------------------------------------------
void vtkHapticVectorFrontMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::FrontModeSettings);
}
