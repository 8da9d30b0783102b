// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticGuideMode.h"

#include "VTK/Modes/HapticModeSettings.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticGuideMode);
vtkCxxSetSmartPointerMacro(vtkHapticGuideMode, Path, vtkPolyData);
vtkCxxSetSmartPointerMacro(vtkHapticGuideMode, Surface, vtkPolyData);
vtkCxxSetSmartPointerMacro(vtkHapticGuideMode, DistanceField, vtkImageData);

//------------------------------------------------------------------------------
vtkHapticGuideMode::vtkHapticGuideMode()
{
  this->Kind = GUIDE;
}

//------------------------------------------------------------------------------
vtkHapticGuideMode::~vtkHapticGuideMode() = default;

//------------------------------------------------------------------------------
vtkPolyData* vtkHapticGuideMode::GetPath()
{
  return this->Path;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHapticGuideMode::GetSurface()
{
  return this->Surface;
}

//------------------------------------------------------------------------------
vtkImageData* vtkHapticGuideMode::GetDistanceField()
{
  return this->DistanceField;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticGuideMode::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  vtkDataObject* const shapes[] = { this->Path, this->Surface, this->DistanceField };
  for (vtkDataObject* const shape : shapes)
  {
    time = shape ? std::max(time, shape->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkHapticGuideMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::GuideModeSettings);
  os << indent << "Path: " << this->Path.Get() << "\n";
  os << indent << "Surface: " << this->Surface.Get() << "\n";
  os << indent << "DistanceField: " << this->DistanceField.Get() << "\n";
}
