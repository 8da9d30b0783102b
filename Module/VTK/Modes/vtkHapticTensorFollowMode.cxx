// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticTensorFollowMode.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticTensorFollowMode);

//------------------------------------------------------------------------------
vtkHapticTensorFollowMode::vtkHapticTensorFollowMode() = default;
vtkHapticTensorFollowMode::~vtkHapticTensorFollowMode() = default;

//------------------------------------------------------------------------------
void vtkHapticTensorFollowMode::SetSheetStrength(vtkPiecewiseFunction* strength)
{
  this->SetSecondStrength(strength);
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticTensorFollowMode::GetSheetStrength()
{
  return this->GetSecondStrength();
}

//------------------------------------------------------------------------------
void vtkHapticTensorFollowMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
