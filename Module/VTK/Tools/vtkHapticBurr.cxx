// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticBurr.h"

#include "VTK/Material/HapticFunctions.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticBurr);

//------------------------------------------------------------------------------
vtkHapticBurr::vtkHapticBurr()
  : Superclass(0.1) // ContactArea
{
}

//------------------------------------------------------------------------------
vtkHapticBurr::~vtkHapticBurr() = default;

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkHapticBurr, SpecificEnergy, vtkPiecewiseFunction);

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticBurr::GetSpecificEnergy()
{
  return VolumeHaptics::ProvideFunction(this->SpecificEnergy);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticBurr::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->SpecificEnergy ? std::max(time, this->SpecificEnergy->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkHapticBurr::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintTool(os, indent, this);
}
