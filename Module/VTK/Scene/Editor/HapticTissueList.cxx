// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticTissueList.h"

#include <iterator>
#include <locale>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

struct TissueAccess
{
  void (vtkHapticProperty::*Set)(int, double);
  double (vtkHapticProperty::*Get)(int);
};

constexpr TissueAccess TissueQuantities[HapticMaterialList::Quantities] = {
  { &vtkHapticProperty::SetTissueStiffness, &vtkHapticProperty::GetTissueStiffness },
  { &vtkHapticProperty::SetTissueFriction, &vtkHapticProperty::GetTissueFriction },
  { &vtkHapticProperty::SetTissueViscosity, &vtkHapticProperty::GetTissueViscosity },
  { &vtkHapticProperty::SetTissueSurfaceStrength, &vtkHapticProperty::GetTissueSurfaceStrength },
};

} // namespace

std::array<double, 3> GetTissueColor(int tissue)
{
  // Pale colours let curves and letters stand out before them; most eyes can tell them apart.
  constexpr std::array<double, 3> colors[] = { { 0.70, 0.83, 0.95 }, { 0.98, 0.80, 0.66 },
    { 0.99, 0.93, 0.63 }, { 0.72, 0.90, 0.87 }, { 0.95, 0.72, 0.74 }, { 0.84, 0.78, 0.93 },
    { 0.80, 0.88, 0.70 }, { 0.86, 0.80, 0.72 } };
  return colors[static_cast<std::size_t>(tissue) % std::size(colors)];
}

vtkIdType HapticTissueList::GetNumberOfRows() const
{
  return this->Property ? this->Property->GetNumberOfTissues() : 0;
}

std::string HapticTissueList::GetTitle() const
{
  const vtkIdType tissues = this->GetNumberOfRows();
  return !this->Property ? "There is no haptic property to edit"
    : tissues == 0       ? "The property has no tissues: apply a preset"
                         : "Tissues (" + std::to_string(tissues) + ")";
}

std::string HapticTissueList::Describe(int tissue) const
{
  double range[2];
  this->Property->GetTissueRange(tissue, range);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << this->Property->GetTissueName(tissue) << ", " << range[0] << " to " << range[1];
  return text.str();
}

double HapticTissueList::ReadValue(int tissue, int quantity) const
{
  return (this->Property->*TissueQuantities[quantity].Get)(tissue);
}

void HapticTissueList::WriteValue(int tissue, int quantity, double value)
{
  (this->Property->*TissueQuantities[quantity].Set)(tissue, value);
}

} // namespace VolumeHaptics
