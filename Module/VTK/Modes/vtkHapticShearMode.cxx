// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticShearMode.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticShearMode);

//------------------------------------------------------------------------------
vtkHapticShearMode::vtkHapticShearMode() = default;
vtkHapticShearMode::~vtkHapticShearMode() = default;

//------------------------------------------------------------------------------
void vtkHapticShearMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
