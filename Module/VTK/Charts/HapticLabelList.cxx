// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticLabelList.h"

#include "VTK/Charts/HapticAxisTop.h"
#include "VTK/Charts/HapticPresentLabels.h"

#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{

const LabelQuantity& HapticLabelList::GetQuantity(int quantity)
{
  static const LabelQuantity quantities[Quantities] = {
    { "Stiffness (N/m)", 1000.0, 1e5, &vtkHapticLabelTable::SetStiffness,
      &vtkHapticLabelTable::GetStiffness },
    { "Friction", 1.0, 10.0, &vtkHapticLabelTable::SetFriction, &vtkHapticLabelTable::GetFriction },
    { "Viscosity (N)", 1.0, 100.0, &vtkHapticLabelTable::SetViscosity,
      &vtkHapticLabelTable::GetViscosity },
    { "Strength (N)", 5.0, 100.0, &vtkHapticLabelTable::SetSurfaceStrength,
      &vtkHapticLabelTable::GetSurfaceStrength },
  };
  return quantities[quantity];
}

//------------------------------------------------------------------------------
bool HapticLabelList::IsCounted() const
{
  return this->Image == this->CountedImage &&
    (!this->Image || this->Image->GetMTime() < this->CountTime);
}

void HapticLabelList::Count()
{
  this->CountedImage = this->Image;
  this->CountTime.Modified();
  this->Counting.Forget();
  this->Present.clear();
  this->Counted = this->Image ? this->Image->GetPointData()->GetScalars() : nullptr;
  if (this->Counted && IsQuicklySwept(this->Counted))
  {
    this->Present = FindPresentLabels(this->Counted, [](double) { return true; });
    this->Counted = nullptr;
  }
  else if (this->Counted)
  {
    this->Present = FindSpreadLabels(this->Counted);
    this->FollowCount();
  }
}

//------------------------------------------------------------------------------
void HapticLabelList::FollowCount()
{
  if (!this->Counted)
  {
    return;
  }
  const vtkSmartPointer<vtkDataArray> labels = this->Counted;
  const std::vector<int>* const present = this->Counting.Follow(this->CountTime.GetMTime(),
    [labels](WorkMonitor& monitor) -> std::optional<std::vector<int>>
    {
      std::vector<int> found =
        FindPresentLabels(labels, [&monitor](double share) { return monitor.GoesOn(share); });
      return monitor.IsCancelled() ? std::nullopt : std::optional(std::move(found));
    });
  if (present)
  {
    this->Present = *present;
    this->ScrollTo(this->FirstRow);
  }
  if (!this->Counting.IsUnderWay())
  {
    this->Counted = nullptr;
    this->Counting.Forget();
  }
}

//------------------------------------------------------------------------------
void HapticLabelList::EndOtherCount()
{
  if (this->Image != this->CountedImage)
  {
    this->Counting.Forget();
    this->Counted = nullptr;
  }
}

//------------------------------------------------------------------------------
double HapticLabelList::GetCountedShare() const
{
  return this->Counted ? this->Counting.GetProgress() : 1.0;
}

//------------------------------------------------------------------------------
vtkIdType HapticLabelList::GetNumberOfLabels() const
{
  return !this->Table ? 0
    : this->Image     ? static_cast<vtkIdType>(this->Present.size())
                      : this->Table->GetNumberOfLabels();
}

int HapticLabelList::GetLabel(vtkIdType row) const
{
  return this->Image ? this->Present[static_cast<std::size_t>(row)] : this->Table->GetLabel(row);
}

vtkIdType HapticLabelList::FindRow(int label) const
{
  vtkIdType first = 0;
  const vtkIdType rows = this->GetNumberOfLabels();
  for (vtkIdType length = rows; length > 0;)
  {
    const vtkIdType half = length / 2;
    const bool isBehind = this->GetLabel(first + half) < label;
    first = isBehind ? first + half + 1 : first;
    length = isBehind ? length - half - 1 : half;
  }
  return first < rows && this->GetLabel(first) == label ? first : -1;
}

//------------------------------------------------------------------------------
void HapticLabelList::SetVisibleRows(vtkIdType rows)
{
  this->VisibleRows = rows;
  this->ScrollTo(this->FirstRow);
}

void HapticLabelList::ScrollTo(vtkIdType first)
{
  const vtkIdType last = std::max<vtkIdType>(0, this->GetNumberOfLabels() - this->VisibleRows);
  this->FirstRow = std::clamp<vtkIdType>(first, 0, last);
}

//------------------------------------------------------------------------------
bool HapticLabelList::Select(int label)
{
  const vtkIdType row = this->FindRow(label);
  if (row < 0)
  {
    return false;
  }
  this->Selected = label;
  if (row < this->FirstRow || row >= this->FirstRow + this->VisibleRows)
  {
    this->ScrollTo(row - this->VisibleRows / 2);
  }
  this->FitEnds();
  return true;
}

std::optional<int> HapticLabelList::GetSelected() const
{
  return this->Selected && this->FindRow(*this->Selected) >= 0 ? this->Selected : std::nullopt;
}

//------------------------------------------------------------------------------
double HapticLabelList::GetValue(int quantity) const
{
  const std::optional<int> label = this->GetSelected();
  return label ? (this->Table->*GetQuantity(quantity).Get)(*label) : -1.0;
}

void HapticLabelList::SetValue(int quantity, double value)
{
  if (const std::optional<int> label = this->GetSelected())
  {
    (this->Table->*GetQuantity(quantity).Set)(*label, value);
  }
}

//------------------------------------------------------------------------------
void HapticLabelList::FitEnds()
{
  constexpr double room = 1.1;
  for (int quantity = 0; quantity < Quantities; ++quantity)
  {
    const LabelQuantity& shown = GetQuantity(quantity);
    const double value = this->GetValue(quantity);
    this->Ends[static_cast<std::size_t>(quantity)] =
      room * value > shown.Usual ? std::min(RoundUp(room * value), shown.Most) : shown.Usual;
  }
}

//------------------------------------------------------------------------------
std::string HapticLabelList::Describe(int label) const
{
  const std::string name = this->Table->GetLabelName(label);
  return std::to_string(label) + (name.empty() ? "" : " ") + name;
}

} // namespace VolumeHaptics
