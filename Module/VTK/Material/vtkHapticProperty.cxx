// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticProperty.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Material/HapticPresets.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Material/HapticProposal.h"
#include "VTK/Material/HapticTissues.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticProperty);

namespace
{

/** Returns the value that a function without points stands for. */
double GetDefault(vtkPiecewiseFunction* (vtkHapticProperty::*get)())
{
  const auto* const function = std::find_if(std::begin(VolumeHaptics::PropertyFunctions),
    std::end(VolumeHaptics::PropertyFunctions),
    [get](const VolumeHaptics::PropertyFunction& one) { return one.Get == get; });
  return function->Default;
}

bool ApplyScaledPreset(
  vtkHapticProperty* self, const char* name, const VolumeHaptics::PresetScale& scale)
{
  if (VolumeHaptics::IsPresetFile(name))
  {
    return self->ReadPreset(name);
  }
  if (!VolumeHaptics::FillFromPreset(name, self, scale))
  {
    vtkErrorWithObjectMacro(self, << "There is no preset \""
                                  << (name ? VolumeHaptics::Printable(name) : std::string("(null)"))
                                  << "\". Use one of: " << VolumeHaptics::ListPresets()
                                  << ", or a file of WritePreset() that ends in .json.");
    return false;
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
#define vtkHapticPropertyFunctionMacro(name)                                 \
  vtkCxxSetSmartPointerMacro(vtkHapticProperty, name, vtkPiecewiseFunction); \
  vtkPiecewiseFunction* vtkHapticProperty::Get##name()                       \
  {                                                                          \
    return VolumeHaptics::ProvideFunction(this->name);                       \
  }

vtkHapticPropertyFunctionMacro(Stiffness);
vtkHapticPropertyFunctionMacro(Friction);
vtkHapticPropertyFunctionMacro(Viscosity);
vtkHapticPropertyFunctionMacro(SurfaceStrength);
vtkHapticPropertyFunctionMacro(Distinctness);

//------------------------------------------------------------------------------
struct vtkHapticProperty::vtkInternals
{
  VolumeHaptics::HapticTissues Tissues;
};

//------------------------------------------------------------------------------
vtkHapticProperty::vtkHapticProperty()
  : Internals(new vtkInternals)
{
}

vtkHapticProperty::~vtkHapticProperty() = default;

//------------------------------------------------------------------------------
bool vtkHapticProperty::ApplyPreset(const char* name)
{
  return ApplyScaledPreset(this, name, {});
}

//------------------------------------------------------------------------------
bool vtkHapticProperty::ApplyPreset(const char* name, vtkImageData* image)
{
  VolumeHaptics::PresetScale scale;
  std::string error;
  if (!VolumeHaptics::ComputePresetScale(name, image, this, scale, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return ApplyScaledPreset(this, name, scale);
}

//------------------------------------------------------------------------------
vtkStringArray* vtkHapticProperty::GetPresetNames()
{
  static const vtkSmartPointer<vtkStringArray> names = VolumeHaptics::MakePresetNames();
  return names;
}

//------------------------------------------------------------------------------
bool vtkHapticProperty::WritePreset(const char* file)
{
  std::string error;
  if (!VolumeHaptics::WritePresetFile(file ? file : "", this, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticProperty::ReadPreset(const char* file)
{
  std::string error;
  if (!VolumeHaptics::ReadPresetFile(file ? file : "", this, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHapticProperty::AddTissue(const char* name, double low, double high)
{
  std::string error;
  const int tissue = this->Internals->Tissues.Add({ name ? name : "", low, high }, error);
  if (tissue < 0)
  {
    vtkErrorMacro(<< VolumeHaptics::Printable(error));
    return -1;
  }
  this->Modified();
  return tissue;
}

//------------------------------------------------------------------------------
void vtkHapticProperty::RemoveAllTissues()
{
  if (this->GetNumberOfTissues() > 0)
  {
    this->Internals->Tissues.Clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHapticProperty::GetNumberOfTissues()
{
  return this->Internals->Tissues.GetSize();
}

//------------------------------------------------------------------------------
bool vtkHapticProperty::HasTissue(int tissue)
{
  const int tissues = this->GetNumberOfTissues();
  if (tissue < 0 || tissue >= tissues)
  {
    vtkErrorMacro("There is no tissue " << tissue << " among " << tissues
                                        << "; they are numbered from 0. AddTissue() adds one.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
const char* vtkHapticProperty::GetTissueName(int tissue)
{
  return this->HasTissue(tissue) ? this->Internals->Tissues.Get(tissue).Name.c_str() : "";
}

//------------------------------------------------------------------------------
void vtkHapticProperty::GetTissueRange(int tissue, double range[2])
{
  if (range && this->HasTissue(tissue))
  {
    range[0] = this->Internals->Tissues.Get(tissue).Low;
    range[1] = this->Internals->Tissues.Get(tissue).High;
  }
}

//------------------------------------------------------------------------------
#define vtkHapticPropertyTissueMacro(name)                                                        \
  void vtkHapticProperty::SetTissue##name(int tissue, double value)                               \
  {                                                                                               \
    if (this->HasTissue(tissue) && value != this->GetTissue##name(tissue))                        \
    {                                                                                             \
      this->Internals->Tissues.SetValue(                                                          \
        this->Get##name(), tissue, value, GetDefault(&vtkHapticProperty::Get##name));             \
    }                                                                                             \
  }                                                                                               \
  double vtkHapticProperty::GetTissue##name(int tissue)                                           \
  {                                                                                               \
    return this->HasTissue(tissue) ? this->Internals->Tissues.GetValue(this->Get##name(), tissue, \
                                       GetDefault(&vtkHapticProperty::Get##name))                 \
                                   : 0.0;                                                         \
  }

vtkHapticPropertyTissueMacro(Stiffness);
vtkHapticPropertyTissueMacro(Friction);
vtkHapticPropertyTissueMacro(Viscosity);
vtkHapticPropertyTissueMacro(SurfaceStrength);

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
    CopyFunction((source->*function.Get)(), (this->*function.Get)());
  }
  if (!(this->Internals->Tissues == source->Internals->Tissues))
  {
    this->Internals->Tissues = source->Internals->Tissues;
    this->Modified();
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
  os << indent << "Tissues:" << (this->GetNumberOfTissues() == 0 ? " (none)" : "") << "\n";
  for (int i = 0; i < this->GetNumberOfTissues(); ++i)
  {
    const VolumeHaptics::NamedTissue& tissue = this->Internals->Tissues.Get(i);
    os << indent.GetNextIndent() << tissue.Name << ": " << tissue.Low << " to " << tissue.High
       << "\n";
  }
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
