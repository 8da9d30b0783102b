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

HapticForceHistory::HapticForceHistory()
{
  for (int c = 0; c < Curves; ++c)
  {
    this->Table.GetForce(c)->Allocate(2 * (Intervals + 2));
  }
  this->Table.GetTime()->Allocate(2 * (Intervals + 2));
}

HapticForceHistory::~HapticForceHistory() = default;

void HapticForceHistory::Add(const State& state, double span)
{
  if (!this->States.empty() && state.Time < this->States.back().Time)
  {
    this->States.clear();
  }
  this->States.push_back(state);
  for (double& force : this->States.back().Forces)
  {
    force = HapticForceTable::MakeDrawable(force);
  }
  while (this->States.front().Time < state.Time - span)
  {
    this->States.pop_front();
  }
  this->IsPlotted = false;
}

void HapticForceHistory::Clear()
{
  this->States.clear();
  this->IsPlotted = false;
}

void HapticForceHistory::SetModes(const std::vector<std::string>& names)
{
  if (this->Table.SetModes(names))
  {
    this->IsPlotted = false;
  }
}

vtkTable* HapticForceHistory::Plot(double span)
{
  if (this->IsPlotted)
  {
    return this->Table.Get();
  }
  this->IsPlotted = true;
  this->Table.Clear();
  const int curves = this->Table.GetCurves();
  const double end = this->States.empty() ? 0.0 : this->States.back().Time;
  const double width = span / Intervals;
  // Count intervals from time 0 instead of the present, so that a peak stays in its interval from
  // frame to frame.
  const auto intervalOf = [&](const State& s) { return std::floor(s.Time / width); };
  for (auto from = this->States.begin(); from != this->States.end();)
  {
    const double interval = intervalOf(*from);
    std::array<double, Curves> low = from->Forces;
    std::array<double, Curves> high = from->Forces;
    std::array<bool, Curves> isFalling = {}; // whether the largest force precedes the smallest
    auto to = from;
    do
    {
      for (int c = 0; c < curves; ++c)
      {
        const double force = to->Forces[c];
        isFalling[c] = force < low[c] || (isFalling[c] && force <= high[c]);
        low[c] = std::min(low[c], force);
        high[c] = std::max(high[c], force);
      }
      ++to;
    } while (to != this->States.end() && intervalOf(*to) == interval);
    const double times[2] = { from->Time, (to - 1)->Time };
    for (int i = 0; i < 2; ++i)
    {
      this->Table.GetTime()->InsertNextValue(static_cast<float>(times[i] - end));
      for (int c = 0; c < curves; ++c)
      {
        const bool isLow = (i == 1) == isFalling[c];
        this->Table.GetForce(c)->InsertNextValue(static_cast<float>(isLow ? low[c] : high[c]));
      }
    }
    from = to;
  }
  this->Table.Get()->Modified();
  return this->Table.Get();
}

double HapticForceHistory::GetRange() const
{
  double largest = 0.0;
  for (const State& state : this->States)
  {
    largest = std::max(largest, *std::max_element(state.Forces.begin(), state.Forces.end()));
  }
  // Leave space above the curve. Show at least 0.5 N, so that noise does not fill the plot.
  const double wanted = std::max(0.5, 1.05 * largest);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (wanted <= factor * power * (1.0 + 1e-9))
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

} // namespace VolumeHaptics
