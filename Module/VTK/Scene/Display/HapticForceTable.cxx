// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticForceTable.h"

#include "VTK/Scene/Base/HapticHistogram.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

HapticForceTable::HapticForceTable()
{
  static const char* const names[] = { "Time", "Normal", "Friction", "Drag", "Whole" };
  for (int c = 0; c <= Curves; ++c)
  {
    this->Columns[c]->SetName(names[c]);
    this->Table->AddColumn(this->Columns[c]);
  }
}

HapticForceTable::~HapticForceTable() = default;

bool HapticForceTable::SetModes(const std::vector<std::string>& names)
{
  const int count = Curves + static_cast<int>(std::min(names.size(), ModeColorCount));
  bool isSame = count == this->Count;
  for (int c = Curves; isSame && c < count; ++c)
  {
    const char* const name = this->GetForce(c)->GetName();
    isSame = name && names[static_cast<std::size_t>(c - Curves)] == name;
  }
  if (isSame)
  {
    return false;
  }
  this->Table->Initialize();
  this->Count = count;
  for (int c = Curves; c < count; ++c)
  {
    this->GetForce(c)->SetName(names[static_cast<std::size_t>(c - Curves)].c_str());
  }
  this->Clear();
  for (int c = 0; c <= count; ++c)
  {
    this->Table->AddColumn(this->Columns[c]);
  }
  this->Table->Modified();
  return true;
}

void HapticForceTable::Clear()
{
  for (auto& column : this->Columns)
  {
    column->SetNumberOfValues(0);
  }
}

void HapticForceTable::Read(vtkPolyData* trace)
{
  this->Clear();
  vtkPointData* const arrays = trace->GetPointData();
  const auto insert = [&](vtkFloatArray* column, const char* name, auto&& value)
  {
    vtkDataArray* const array = arrays->GetArray(name);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      column->InsertNextValue(static_cast<float>(value(array, i)));
    }
  };
  insert(this->GetTime(), "Time",
    [](vtkDataArray* array, vtkIdType i) { return array->GetComponent(i, 0); });
  static const char* const parts[] = { "NormalForce", "FrictionForce", "DragForce" };
  for (int c = 0; c < 3; ++c)
  {
    insert(this->GetForce(c), parts[c],
      [](vtkDataArray* array, vtkIdType i) { return MakeDrawable(array->GetComponent(i, 0)); });
  }
  insert(this->GetForce(3), "Force",
    [](vtkDataArray* array, vtkIdType i)
    { return MakeDrawable(vtkMath::Norm(array->GetTuple3(i))); });
  for (int c = Curves; c < this->Count; ++c)
  {
    insert(this->GetForce(c), ("ModeForce_" + std::to_string(c - Curves)).c_str(),
      [](vtkDataArray* array, vtkIdType i)
      { return MakeDrawable(vtkMath::Norm(array->GetTuple3(i))); });
  }
  this->Table->Modified();
}

double HapticForceTable::MakeDrawable(double force)
{
  return std::isfinite(force) ? std::clamp(force, -FarthestShown, FarthestShown) : 0.0;
}

} // namespace VolumeHaptics
