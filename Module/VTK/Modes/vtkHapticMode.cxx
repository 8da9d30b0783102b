// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticMode.h"

#include "VTK/Material/HapticFunctions.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/ModeProposal.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>

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
vtkCxxSetSmartPointerMacro(vtkHapticMode, Strength, vtkPiecewiseFunction);

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticMode::GetStrength()
{
  return VolumeHaptics::ProvideFunction(this->Strength);
}

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkHapticMode, SecondStrength, vtkPiecewiseFunction);

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticMode::GetSecondStrength()
{
  return VolumeHaptics::ProvideFunction(this->SecondStrength);
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
