// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticPointShell.h"

#include "VTK/Tools/ToolKind.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticPointShell);

//------------------------------------------------------------------------------
vtkHapticPointShell::vtkHapticPointShell()
  : Superclass(25.0) // ContactArea
{
}

//------------------------------------------------------------------------------
vtkHapticPointShell::~vtkHapticPointShell() = default;

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkHapticPointShell, Mesh, vtkPolyData);

//------------------------------------------------------------------------------
vtkPolyData* vtkHapticPointShell::GetMesh()
{
  return this->Mesh;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticPointShell::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Mesh ? std::max(time, this->Mesh->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkHapticPointShell::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintTool(os, indent, this);
}
