// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticProperty.h"

#include "VTK/Baking/HapticPresets.h"
#include "VTK/Baking/HapticSettingLists.h"
#include "VTK/Files/HapticFiles.h"
#include "VTK/Proposal/HapticProposal.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticProperty);

//------------------------------------------------------------------------------
#define vtkHapticPropertyFunctionMacro(name)                        \
  void vtkHapticProperty::Set##name(vtkPiecewiseFunction* function) \
  {                                                                 \
    if (this->name != function)                                     \
    {                                                               \
      this->name = function;                                        \
      this->Modified();                                             \
    }                                                               \
  }                                                                 \
  vtkPiecewiseFunction* vtkHapticProperty::Get##name()              \
  {                                                                 \
    if (!this->name)                                                \
    {                                                               \
      this->name = vtkSmartPointer<vtkPiecewiseFunction>::New();    \
    }                                                               \
    return this->name;                                              \
  }

vtkHapticPropertyFunctionMacro(Stiffness);
vtkHapticPropertyFunctionMacro(Friction);
vtkHapticPropertyFunctionMacro(Viscosity);
vtkHapticPropertyFunctionMacro(SurfaceStrength);
vtkHapticPropertyFunctionMacro(Distinctness);

//------------------------------------------------------------------------------
vtkHapticProperty::vtkHapticProperty() = default;
vtkHapticProperty::~vtkHapticProperty() = default;

//------------------------------------------------------------------------------
bool vtkHapticProperty::ApplyPreset(const char* name)
{
  if (!VolumeHaptics::FillFromPreset(name, this))
  {
    vtkErrorMacro(<< "There is no preset \""
                  << (name ? VolumeHaptics::Printable(name) : std::string("(null)"))
                  << "\". Use one of: " << VolumeHaptics::ListPresets() << ".");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkHapticProperty::GetPresetNames()
{
  static const vtkSmartPointer<vtkStringArray> names = VolumeHaptics::MakePresetNames();
  return names;
}

//------------------------------------------------------------------------------
bool vtkHapticProperty::ProposeFromImage(vtkImageData* image)
{
  VolumeHaptics::ProposalInput input;
  VolumeHaptics::MaterialProposal proposal;
  std::string error;
  if (!VolumeHaptics::ReadProposalInput(image, this->Component, input, error) ||
    !VolumeHaptics::ProposeFromVolume(input, {}, proposal, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  VolumeHaptics::FillFromProposal(proposal, this);
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticProperty::NoteProposal(vtkTable* boundaries, int kernelRadius)
{
  this->ProposedBoundaries = boundaries;
  this->ProposedKernelRadius = kernelRadius;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkTable* vtkHapticProperty::GetProposedBoundaries()
{
  return this->ProposedBoundaries;
}

//------------------------------------------------------------------------------
void vtkHapticProperty::SetVisibilityFrom(vtkVolumeProperty* property)
{
  if (this->VisibilityFrom != property)
  {
    this->VisibilityFrom = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkVolumeProperty* vtkHapticProperty::GetVisibilityFrom()
{
  return this->VisibilityFrom;
}

//------------------------------------------------------------------------------
void vtkHapticProperty::NoteNoiseRamp(double start, double full)
{
  this->NoiseRamp[0] = start;
  this->NoiseRamp[1] = full;
}

//------------------------------------------------------------------------------
void vtkHapticProperty::DeepCopy(vtkHapticProperty* source)
{
  using namespace VolumeHaptics;
  if (!source || source == this)
  {
    return;
  }
  for (const PropertyFunction& function : PropertyFunctions)
  {
    (this->*function.Get)()->DeepCopy((source->*function.Get)());
  }
  this->SetVisibilityFrom(source->GetVisibilityFrom());
  this->ProposedBoundaries = source->ProposedBoundaries;
  this->ProposedKernelRadius = source->ProposedKernelRadius;
  for (const PropertySetting& setting : PropertySettings)
  {
    setting.Set(this, setting.Get(source));
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticProperty::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* owned : std::initializer_list<vtkObject*>{ this->Stiffness, this->Friction,
         this->Viscosity, this->SurfaceStrength, this->Distinctness, this->VisibilityFrom })
  {
    time = owned ? std::max(time, owned->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkHapticProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, vtkObject* object)
  {
    os << indent << name << ": ";
    if (object)
    {
      os << "\n";
      object->PrintSelf(os, indent.GetNextIndent());
    }
    else
    {
      os << "(none)\n";
    }
  };
  print("Stiffness", this->Stiffness);
  print("Friction", this->Friction);
  print("Viscosity", this->Viscosity);
  print("SurfaceStrength", this->SurfaceStrength);
  print("Distinctness", this->Distinctness);
  print("VisibilityFrom", this->VisibilityFrom);
  print("ProposedBoundaries", this->ProposedBoundaries);
  os << indent << "ProposedKernelRadius: " << this->ProposedKernelRadius << "\n";
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::PropertySettings);
  os << indent << "NoiseRamp: ";
  if (this->NoiseRamp[1] > 0.0)
  {
    os << "0 at " << this->NoiseRamp[0] << ", 1 at " << this->NoiseRamp[1]
       << " scalar units per world unit\n";
  }
  else
  {
    os << "(none)\n";
  }
}
