// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticGuideMode.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticGuideMode);

//------------------------------------------------------------------------------
vtkHapticGuideMode::vtkHapticGuideMode() = default;
vtkHapticGuideMode::~vtkHapticGuideMode() = default;

//------------------------------------------------------------------------------
void vtkHapticGuideMode::SetPath(vtkPolyData* path)
{
  if (this->Path != path)
  {
    this->Path = path;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHapticGuideMode::GetPath()
{
  return this->Path;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticGuideMode::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Path ? std::max(time, this->Path->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkHapticGuideMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Path: " << this->Path.Get() << "\n";
}
