// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticVectorFollowMode.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticVectorFollowMode);

//------------------------------------------------------------------------------
vtkHapticVectorFollowMode::vtkHapticVectorFollowMode() = default;
vtkHapticVectorFollowMode::~vtkHapticVectorFollowMode() = default;

//------------------------------------------------------------------------------
void vtkHapticVectorFollowMode::SetPush(vtkPiecewiseFunction* strength)
{
  this->SetSecondStrength(strength);
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticVectorFollowMode::GetPush()
{
  return this->GetSecondStrength();
}

//------------------------------------------------------------------------------
void vtkHapticVectorFollowMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
