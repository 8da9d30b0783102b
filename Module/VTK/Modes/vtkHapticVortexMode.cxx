// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticVortexMode.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticVortexMode);

//------------------------------------------------------------------------------
vtkHapticVortexMode::vtkHapticVortexMode() = default;
vtkHapticVortexMode::~vtkHapticVortexMode() = default;

//------------------------------------------------------------------------------
void vtkHapticVortexMode::SetAxisStrength(vtkPiecewiseFunction* strength)
{
  this->SetSecondStrength(strength);
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticVortexMode::GetAxisStrength()
{
  return this->GetSecondStrength();
}

//------------------------------------------------------------------------------
void vtkHapticVortexMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
