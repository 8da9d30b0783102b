// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of vtkVolumeHapticsFilter as numbers and as text.
#include "vtkVolumeHapticsFilter.h"

#include "vtkHapticProperty.h"

#include <cmath>
#include <utility>

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::CheckSettings(double rate) const
{
  const std::pair<const char*, double> settings[] = { { "ServoRate", rate },
    { "MetersPerWorldUnit", this->MetersPerWorldUnit }, { "ForceFieldGain", this->ForceFieldGain },
    { "ForceFieldDamping", this->ForceFieldDamping }, { "IsoValue", this->IsoValue },
    { "ProxyRadius", this->ProxyRadius }, { "MaximumForce", this->MaximumForce },
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
void vtkVolumeHapticsFilter::PrintSettings(ostream& os, vtkIndent indent)
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
  static const char* const methods[] = { "Proxy", "ForceField", "SurfaceProxy" };
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
  os << indent << "MaximumForce: " << this->MaximumForce << " N\n";
  os << indent << "MaximumStiffness: " << this->MaximumStiffness << " N/m\n";
}
