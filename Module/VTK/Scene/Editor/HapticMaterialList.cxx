// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "VTK/Scene/Editor/HapticAxisTop.h"

#include <algorithm>

namespace VolumeHaptics
{

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

} // namespace VolumeHaptics
