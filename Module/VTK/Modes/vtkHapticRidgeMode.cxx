// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRidgeMode.h"

#include "VTK/Modes/HapticModeSettings.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticRidgeMode);

//------------------------------------------------------------------------------
vtkHapticRidgeMode::vtkHapticRidgeMode() = default;
vtkHapticRidgeMode::~vtkHapticRidgeMode() = default;

//------------------------------------------------------------------------------
void vtkHapticRidgeMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::RidgeModeSettings);
}
