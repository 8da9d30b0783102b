// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticNeedle.h"

#include "VTK/Material/HapticFunctions.h"
#include "VTK/Material/HapticPresets.h"
#include "VTK/Tools/NeedleTrace.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticNeedle);

//------------------------------------------------------------------------------
vtkHapticNeedle::vtkHapticNeedle() = default;
vtkHapticNeedle::~vtkHapticNeedle() = default;

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkHapticNeedle, ShaftFriction, vtkPiecewiseFunction);
vtkCxxSetSmartPointerMacro(vtkHapticNeedle, CuttingForce, vtkPiecewiseFunction);

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticNeedle::GetShaftFriction()
{
  return VolumeHaptics::ProvideFunction(this->ShaftFriction);
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticNeedle::GetCuttingForce()
{
  return VolumeHaptics::ProvideFunction(this->CuttingForce);
}

//------------------------------------------------------------------------------
bool vtkHapticNeedle::ApplyPreset(const char* name)
{
  if (!VolumeHaptics::FillCuttingForce(name, this->GetCuttingForce()))
  {
    vtkErrorMacro("There are no cutting forces of a needle for the preset \""
      << (name ? name : "") << "\". Cure: use one of those of vtkHapticProperty that begin with "
      << "\"CT\", or fill GetCuttingForce().");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticNeedle::MakeTrack(vtkPolyData* trace, vtkPolyData* track)
{
  if (!track)
  {
    vtkGenericWarningMacro("MakeTrack() needs a polydata for the track, but got a null pointer.");
    return false;
  }
  const std::string error = VolumeHaptics::MakeNeedleTrack(trace, track);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(track, << error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticNeedle::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkPiecewiseFunction* const function :
    { this->ShaftFriction.Get(), this->CuttingForce.Get() })
  {
    time = function ? std::max(time, function->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkHapticNeedle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintTool(os, indent, this);
}
