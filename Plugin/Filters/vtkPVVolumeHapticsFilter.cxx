// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVVolumeHapticsFilter.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticProperty.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVVolumeHapticsFilter);

//------------------------------------------------------------------------------
vtkPVVolumeHapticsFilter::vtkPVVolumeHapticsFilter()
{
  this->Stiffness.Scale = 1000.0;
  this->SurfaceStrength.Scale = 4.0;
}

//------------------------------------------------------------------------------
vtkPVVolumeHapticsFilter::~vtkPVVolumeHapticsFilter() = default;

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::Curve::CopyTo(vtkPiecewiseFunction* function) const
{
  if (!this->Shape)
  {
    function->RemoveAllPoints();
    return;
  }
  function->DeepCopy(this->Shape);
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    node[1] *= this->Scale;
    function->SetNodeValue(i, node);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void vtkPVVolumeHapticsFilter::Choose(T& setting, const T& value)
{
  if (!(setting == value))
  {
    setting = value;
    this->Chosen.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetPreset(const char* preset)
{
  this->Choose(this->Preset, std::string(preset && *preset ? preset : "Custom"));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetStiffnessFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Stiffness.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetFrictionFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Friction.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetViscosityFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Viscosity.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSurfaceStrengthFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->SurfaceStrength.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetDistinctnessFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Distinctness.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetStiffnessScale(double scale)
{
  this->Choose(this->Stiffness.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetFrictionScale(double scale)
{
  this->Choose(this->Friction.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetViscosityScale(double scale)
{
  this->Choose(this->Viscosity.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSurfaceStrengthScale(double scale)
{
  this->Choose(this->SurfaceStrength.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetDistinctnessFromNoise(bool fromNoise)
{
  this->Choose(this->DistinctnessFromNoise, fromNoise);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSurfaceSide(int side)
{
  this->Choose(this->SurfaceSide, side);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetComponent(int component)
{
  this->GetProperty()->SetComponent(component);
}

//------------------------------------------------------------------------------
double* vtkPVVolumeHapticsFilter::GetNoiseRamp()
{
  return this->GetProperty()->GetNoiseRamp();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetInputArrayToProcess(
  int index, int port, int connection, int association, const char* name)
{
  if (name && *name)
  {
    this->Superclass::SetInputArrayToProcess(index, port, connection, association, name);
    return;
  }
  this->SetInputArrayToProcess(index, port, connection, vtkDataObject::FIELD_ASSOCIATION_POINTS,
    vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVVolumeHapticsFilter::GetMaterialTime() const
{
  vtkMTimeType time = this->Chosen;
  for (const Curve* curve : { &this->Stiffness, &this->Friction, &this->Viscosity,
         &this->SurfaceStrength, &this->Distinctness })
  {
    time = std::max(time, curve->Shape ? curve->Shape->GetMTime() : 0);
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::FillProperty()
{
  vtkHapticProperty* const property = this->GetProperty();
  if (this->Preset != "Custom")
  {
    this->IsPresetKnown = property->ApplyPreset(this->Preset.c_str());
    return;
  }
  this->IsPresetKnown = true;
  this->Stiffness.CopyTo(property->GetStiffness());
  this->Friction.CopyTo(property->GetFriction());
  this->Viscosity.CopyTo(property->GetViscosity());
  this->SurfaceStrength.CopyTo(property->GetSurfaceStrength());
  this->Distinctness.CopyTo(property->GetDistinctness());
  if (this->DistinctnessFromNoise)
  {
    property->GetDistinctness()->RemoveAllPoints();
  }
  property->SetDistinctnessFromNoise(this->DistinctnessFromNoise);
  property->SetSurfaceSide(this->SurfaceSide);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVVolumeHapticsFilter::GetMTime()
{
  if (this->GetMaterialTime() > this->Filled)
  {
    this->FillProperty();
    this->Filled.Modified();
  }
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
int vtkPVVolumeHapticsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The property has reported the wrong name.
  return this->IsPresetKnown ? this->Superclass::RequestData(request, inputs, outputs) : 0;
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "StiffnessScale: " << this->Stiffness.Scale << " N/m\n";
  os << indent << "FrictionScale: " << this->Friction.Scale << "\n";
  os << indent << "ViscosityScale: " << this->Viscosity.Scale << " N\n";
  os << indent << "SurfaceStrengthScale: " << this->SurfaceStrength.Scale << " N\n";
  os << indent << "DistinctnessFromNoise: " << (this->DistinctnessFromNoise ? "On" : "Off") << "\n";
  os << indent << "SurfaceSide: " << this->SurfaceSide << "\n";
}
