// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsAlgorithm.h"

#include "VTK/Baking/HapticMethods.h"

#include "vtkHapticProperty.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <utility>

//------------------------------------------------------------------------------
vtkVolumeHapticsAlgorithm::vtkVolumeHapticsAlgorithm() = default;

//------------------------------------------------------------------------------
vtkVolumeHapticsAlgorithm::~vtkVolumeHapticsAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::SetProperty(vtkHapticProperty* property)
{
  if (this->Property != property)
  {
    this->Property = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticProperty* vtkVolumeHapticsAlgorithm::GetProperty()
{
  if (!this->Property)
  {
    this->Property = vtkSmartPointer<vtkHapticProperty>::New();
  }
  return this->Property;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeHapticsAlgorithm::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Property ? std::max(time, this->Property->GetMTime()) : time;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVolumeHapticsAlgorithm::GetMethodNames()
{
  static const vtkSmartPointer<vtkStringArray> names = []
  {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    for (const VolumeHaptics::MethodChoice& choice : VolumeHaptics::MethodChoices())
    {
      array->InsertNextValue(choice.Name);
    }
    return array;
  }();
  return names;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::Choose(std::size_t choice)
{
  const VolumeHaptics::MethodChoice& chosen = VolumeHaptics::MethodChoices()[choice];
  this->SetMethod(chosen.Method);
  if (chosen.Solver != VolumeHaptics::MethodChoice::AnySolver)
  {
    this->SetSolver(chosen.Solver);
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsAlgorithm::SetMethodByName(const char* name)
{
  const auto& all = VolumeHaptics::MethodChoices();
  const std::string wanted = name ? name : "";
  std::string known;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (wanted == all[i].Name)
    {
      this->Choose(i);
      return true;
    }
    known += (i > 0 ? ", \"" : "\"") + std::string(all[i].Name) + "\"";
  }
  vtkErrorMacro("There is no method \"" << wanted << "\". Take one of " << known << ".");
  return false;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::GetMethodName()
{
  return VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Name;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::GetMethodText()
{
  return VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Text;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::NextMethod()
{
  const std::size_t now = VolumeHaptics::FindMethodChoice(this->Method, this->Solver);
  this->Choose((now + 1) % VolumeHaptics::MethodChoices().size());
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::CheckSettings(double rate) const
{
  const std::pair<const char*, double> settings[] = { { "ServoRate", rate },
    { "MetersPerWorldUnit", this->MetersPerWorldUnit }, { "ForceFieldGain", this->ForceFieldGain },
    { "ForceFieldDamping", this->ForceFieldDamping }, { "IsoValue", this->IsoValue },
    { "ProxyRadius", this->ProxyRadius }, { "LocalSurfaceRate", this->LocalSurfaceRate },
    { "RecoveryTime", this->RecoveryTime }, { "MaximumForce", this->MaximumForce },
    { "MaximumStiffness", this->MaximumStiffness } };
  for (const auto& [setting, value] : settings)
  {
    if (!std::isfinite(value))
    {
      return std::string("The setting ") + setting +
        " of vtkVolumeHapticsFilter is not a finite number. Set" + setting + "() to one.";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::PrintSettings(ostream& os, vtkIndent indent)
{
  os << indent << "Property: ";
  if (this->Property)
  {
    os << "\n";
    this->Property->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  static const char* const estimators[] = { "CentralDifference", "Gaussian", "CubicBSpline" };
  os << indent << "Method: " << VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Setting
     << "\n";
  os << indent << "Solver: " << (this->Solver == PAPER ? "Paper" : "Precise") << "\n";
  os << indent << "ContactAlignment: " << (this->ContactAlignment == EDGE ? "Edge" : "Distinctness")
     << "\n";
  os << indent << "GradientEstimator: " << estimators[this->GradientEstimator] << "\n";
  os << indent << "KernelRadius: " << this->KernelRadius << " voxels\n";
  os << indent << "ServoRate: " << this->ServoRate << " Hz\n";
  os << indent << "MetersPerWorldUnit: " << this->MetersPerWorldUnit << "\n";
  os << indent << "ForceFieldGain: " << this->ForceFieldGain << "\n";
  os << indent << "ForceFieldDamping: " << this->ForceFieldDamping << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "ProxyRadius: " << this->ProxyRadius << "\n";
  os << indent << "ForceShading: " << (this->ForceShading ? "On" : "Off") << "\n";
  os << indent
     << "LocalSurfaceShape: " << (this->LocalSurfaceShape == QUADRIC ? "Quadric" : "Plane") << "\n";
  os << indent << "LocalSurfaceRate: " << this->LocalSurfaceRate << " Hz\n";
  os << indent << "RecoveryTime: " << this->RecoveryTime << " s\n";
  os << indent << "MaximumForce: " << this->MaximumForce << " N\n";
  os << indent << "MaximumStiffness: " << this->MaximumStiffness << " N/m\n";
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->PrintSettings(os, indent);
}
