// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticGuideMode.h"

#include "VTK/Baking/HapticModeSettings.h"

#include "vtkImageData.h"
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
void vtkHapticGuideMode::SetSurface(vtkPolyData* surface)
{
  if (this->Surface != surface)
  {
    this->Surface = surface;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHapticGuideMode::GetSurface()
{
  return this->Surface;
}

//------------------------------------------------------------------------------
void vtkHapticGuideMode::SetDistanceField(vtkImageData* field)
{
  if (this->DistanceField != field)
  {
    this->DistanceField = field;
    this->Modified();
  }
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
