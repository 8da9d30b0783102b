// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticLabelList.h"

#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Editor/HapticPresentLabels.h"

#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <utility>

namespace VolumeHaptics
{

namespace
{

struct LabelAccess
{
  void (vtkHapticLabelTable::*Set)(int, double);
  double (vtkHapticLabelTable::*Get)(int); ///< -1: the functions decide
};

constexpr LabelAccess LabelQuantities[HapticMaterialList::Quantities] = {
  { &vtkHapticLabelTable::SetStiffness, &vtkHapticLabelTable::GetStiffness },
  { &vtkHapticLabelTable::SetFriction, &vtkHapticLabelTable::GetFriction },
  { &vtkHapticLabelTable::SetViscosity, &vtkHapticLabelTable::GetViscosity },
  { &vtkHapticLabelTable::SetSurfaceStrength, &vtkHapticLabelTable::GetSurfaceStrength },
};

} // namespace

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
    this->ScrollTo(this->GetFirstRow());
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
vtkIdType HapticLabelList::GetNumberOfRows() const
{
  return !this->Table ? 0
    : this->Image     ? static_cast<vtkIdType>(this->Present.size())
                      : this->Table->GetNumberOfLabels();
}

int HapticLabelList::GetKey(vtkIdType row) const
{
  return this->Image ? this->Present[static_cast<std::size_t>(row)] : this->Table->GetLabel(row);
}

vtkObject* HapticLabelList::GetEdited() const
{
  return this->Table;
}

//------------------------------------------------------------------------------
std::string HapticLabelList::GetTitle() const
{
  const vtkIdType labels = this->GetNumberOfRows();
  return labels > 0
    ? "Labels (" + std::to_string(labels) + ")" + DescribeShare(this->GetCountedShare(), "counted")
    : this->Table ? "There are no labels to edit"
                  : "There is no label table to edit";
}

std::array<double, 3> HapticLabelList::GetColor(int label) const
{
  const double* const color = this->Table->GetColor(label);
  return { color[0], color[1], color[2] };
}

//------------------------------------------------------------------------------
bool HapticLabelList::IsFelt(int label) const
{
  return this->Table->GetFelt(label);
}

bool HapticLabelList::IsForbidden(int label) const
{
  return this->Table->GetForbidden(label);
}

void HapticLabelList::ToggleFelt(int label)
{
  this->Table->SetFelt(label, !this->Table->GetFelt(label));
}

void HapticLabelList::ToggleForbidden(int label)
{
  this->Table->SetForbidden(label, !this->Table->GetForbidden(label));
}

//------------------------------------------------------------------------------
bool HapticLabelList::HasMaterial(int label) const
{
  return this->Table->HasMaterial(label);
}

void HapticLabelList::RemoveMaterial(int label)
{
  this->Table->RemoveMaterial(label);
}

//------------------------------------------------------------------------------
double HapticLabelList::ReadValue(int label, int quantity) const
{
  return (this->Table->*LabelQuantities[quantity].Get)(label);
}

void HapticLabelList::WriteValue(int label, int quantity, double value)
{
  (this->Table->*LabelQuantities[quantity].Set)(label, value);
}

//------------------------------------------------------------------------------
std::string HapticLabelList::Describe(int label) const
{
  const std::string name = this->Table->GetLabelName(label);
  return std::to_string(label) + (name.empty() ? "" : " ") + name;
}

} // namespace VolumeHaptics
