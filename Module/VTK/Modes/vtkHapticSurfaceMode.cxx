// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSurfaceMode.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticSurfaceMode);

//------------------------------------------------------------------------------
vtkHapticSurfaceMode::vtkHapticSurfaceMode() = default;
vtkHapticSurfaceMode::~vtkHapticSurfaceMode() = default;

//------------------------------------------------------------------------------
void vtkHapticSurfaceMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
