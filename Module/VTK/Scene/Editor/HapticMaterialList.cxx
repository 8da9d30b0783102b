// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "VTK/Scene/Editor/HapticValueScale.h"

#include <algorithm>
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

const MaterialQuantity& HapticMaterialList::GetQuantity(int quantity)
{
  static const MaterialQuantity quantities[Quantities] = {
    { "Stiffness (N/m)", 1000.0, 1e5 },
    { "Friction", 1.0, 10.0 },
    { "Viscosity (N)", 1.0, 100.0 },
    { "Strength (N)", 5.0, 100.0 },
  };
  return quantities[quantity];
}

//------------------------------------------------------------------------------
vtkIdType HapticMaterialList::FindRow(int key) const
{
  vtkIdType first = 0;
  const vtkIdType rows = this->GetNumberOfRows();
  for (vtkIdType length = rows; length > 0;)
  {
    const vtkIdType half = length / 2;
    const bool isBehind = this->GetKey(first + half) < key;
    first = isBehind ? first + half + 1 : first;
    length = isBehind ? length - half - 1 : half;
  }
  return first < rows && this->GetKey(first) == key ? first : -1;
}

//------------------------------------------------------------------------------
void HapticMaterialList::SetVisibleRows(vtkIdType rows)
{
  this->VisibleRows = rows;
  this->ScrollTo(this->FirstRow);
}

void HapticMaterialList::ScrollTo(vtkIdType first)
{
  const vtkIdType last = std::max<vtkIdType>(0, this->GetNumberOfRows() - this->VisibleRows);
  this->FirstRow = std::clamp<vtkIdType>(first, 0, last);
}

//------------------------------------------------------------------------------
bool HapticMaterialList::Select(int key)
{
  const vtkIdType row = this->FindRow(key);
  if (row < 0)
  {
    return false;
  }
  this->Selected = key;
  if (row < this->FirstRow || row >= this->FirstRow + this->VisibleRows)
  {
    this->ScrollTo(row - this->VisibleRows / 2);
  }
  this->FitEnds();
  return true;
}

std::optional<int> HapticMaterialList::GetSelected() const
{
  return this->Selected && this->FindRow(*this->Selected) >= 0 ? this->Selected : std::nullopt;
}

//------------------------------------------------------------------------------
double HapticMaterialList::GetValue(int quantity) const
{
  const std::optional<int> key = this->GetSelected();
  return key ? this->ReadValue(*key, quantity) : -1.0;
}

void HapticMaterialList::SetValue(int quantity, double value)
{
  if (const std::optional<int> key = this->GetSelected())
  {
    this->WriteValue(*key, quantity, value);
  }
}

//------------------------------------------------------------------------------
void HapticMaterialList::FitEnds()
{
  constexpr double room = 1.1;
  for (int quantity = 0; quantity < Quantities; ++quantity)
  {
    const MaterialQuantity& shown = GetQuantity(quantity);
    const double value = this->GetValue(quantity);
    this->Ends[static_cast<std::size_t>(quantity)] =
      room * value > shown.Usual ? std::min(RoundUp(room * value), shown.Most) : shown.Usual;
  }
}

std::array<double, 3> GetTissueColor(int tissue)
{
  // Pale colours, so that curves and letters stand out. Most people can distinguish them.
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
