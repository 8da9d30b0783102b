// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsAlgorithm.h"

#include "vtkHapticProperty.h"

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
  static const char* const methods[] = { "Proxy", "ForceField", "SurfaceProxy", "LocalSurface" };
  os << indent << "Method: " << methods[this->Method] << "\n";
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
