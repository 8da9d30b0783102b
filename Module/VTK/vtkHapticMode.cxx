// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticMode.h"

#include "VTK/Baking/HapticModeSettings.h"
#include "VTK/Baking/ModeProposal.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>

namespace
{
vtkPiecewiseFunction* Provide(vtkSmartPointer<vtkPiecewiseFunction>& function)
{
  if (!function)
  {
    function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  }
  return function;
}
} // namespace

//------------------------------------------------------------------------------
vtkHapticMode::vtkHapticMode() = default;
vtkHapticMode::~vtkHapticMode() = default;

//------------------------------------------------------------------------------
void vtkHapticMode::SetArrayName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->ArrayName != wanted)
  {
    this->ArrayName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkHapticMode::GetArrayName()
{
  return this->ArrayName;
}

//------------------------------------------------------------------------------
void vtkHapticMode::SetStrength(vtkPiecewiseFunction* strength)
{
  if (this->Strength != strength)
  {
    this->Strength = strength;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticMode::GetStrength()
{
  return Provide(this->Strength);
}

//------------------------------------------------------------------------------
void vtkHapticMode::SetSecondStrength(vtkPiecewiseFunction* strength)
{
  if (this->SecondStrength != strength)
  {
    this->SecondStrength = strength;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticMode::GetSecondStrength()
{
  return Provide(this->SecondStrength);
}

//------------------------------------------------------------------------------
bool vtkHapticMode::ProposeFromImage(vtkImageData* image)
{
  std::string error;
  if (!image)
  {
    vtkErrorMacro("ProposeFromImage() needs an image, but got a null pointer.");
    return false;
  }
  if (!VolumeHaptics::ProposeStrength(this, image, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHapticMode::GetText()
{
  return VolumeHaptics::GetModeText(this);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticMode::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkPiecewiseFunction* const function : { this->Strength.Get(), this->SecondStrength.Get() })
  {
    time = function ? std::max(time, function->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkHapticMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintMode(os, indent, this);
}
