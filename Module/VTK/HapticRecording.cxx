// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticRecording.h"

#include "HapticTipPath.h"
#include "HapticTrace.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

namespace VolumeHaptics
{
namespace
{

template <typename Array>
vtkSmartPointer<Array> NewArray(vtkFieldData* owner, const char* name, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  owner->AddArray(array);
  return array;
}

void AddText(vtkFieldData* owner, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  owner->AddArray(array);
}

void AddVector(vtkDoubleArray* array, const Vector3& v)
{
  array->InsertNextTuple3(v.X, v.Y, v.Z);
}

void AddMatrix(vtkDoubleArray* array, const Affine3& map)
{
  const double offset[3] = { map.Offset.X, map.Offset.Y, map.Offset.Z };
  double m[16] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  for (int row = 0; row < 3; ++row)
  {
    m[4 * row] = map.Linear.Row[row].X;
    m[4 * row + 1] = map.Linear.Row[row].Y;
    m[4 * row + 2] = map.Linear.Row[row].Z;
    m[4 * row + 3] = offset[row];
  }
  array->InsertNextTuple(m);
}

const char* const Units = "points and Tip: world; DeviceTip: m; Time: s; forces, Command, "
                          "Viscosity and SurfaceStrength: N; "
                          "Stiffness: N/m; Value, SurfaceValue and MediumValue: scalar; "
                          "GradientMagnitude: scalar per world";

} // namespace

void HapticRecording::AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model)
{
  this->Models[generation] = std::move(model);
}

vtkSmartPointer<vtkPolyData> HapticRecording::MakeTrace() const
{
  auto trace = vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* const points = trace->GetPointData();
  vtkFieldData* const fields = trace->GetFieldData();
  HapticTrace basics;
  const auto tip = NewArray<vtkDoubleArray>(points, RecordingNames::DeviceTip, 3);
  const auto command = NewArray<vtkDoubleArray>(points, "Command", 3);
  const auto tick = NewArray<vtkIdTypeArray>(points, "Tick", 1);
  const auto enabled = NewArray<vtkUnsignedCharArray>(points, RecordingNames::Enabled, 1);
  const auto placement = NewArray<vtkIntArray>(points, RecordingNames::Placement, 1);
  const auto buttons = NewArray<vtkIntArray>(points, "Buttons", 1);
  const auto armed = NewArray<vtkUnsignedCharArray>(points, "Armed", 1);
  const auto fault = NewArray<vtkUnsignedCharArray>(points, "Fault", 1);
  const auto matrices = NewArray<vtkDoubleArray>(fields, RecordingNames::DeviceToWorld, 16);
  const auto initial =
    NewArray<vtkDoubleArray>(fields, RecordingNames::InitialState, ServoStateSize);
  const auto period = NewArray<vtkDoubleArray>(fields, RecordingNames::TickPeriod, 1);
  const auto caps = NewArray<vtkDoubleArray>(fields, RecordingNames::Caps, 2);
  const auto lost = NewArray<vtkIdTypeArray>(fields, "LostTicks", 1);
  lost->InsertNextValue(static_cast<vtkIdType>(this->LostTicks));
  AddText(fields, "DeviceId", this->DeviceId);
  AddText(fields, "Settings", this->Settings);
  AddText(fields, "Units", Units);
  AddText(fields, "VolumeHash", this->VolumeHash);

  std::map<std::uint64_t, int> placements;
  basics.Reserve(static_cast<vtkIdType>(this->Ticks.size()));
  for (const ServoSnapshot& s : this->Ticks)
  {
    const auto found = this->Models.find(s.Generation);
    if (found == this->Models.end() || !found->second)
    {
      continue;
    }
    const HapticModel& model = *found->second;
    // A placement for every generation, moved or not: the servo carries its state across each.
    const auto [entry, isNew] =
      placements.insert({ s.Generation, static_cast<int>(placements.size()) });
    if (isNew)
    {
      AddMatrix(matrices, model.DeviceToWorld);
    }
    if (initial->GetNumberOfTuples() == 0)
    {
      initial->InsertNextTuple(ToNumbers(s.Before).data());
      period->InsertNextValue(model.Settings.TickPeriod);
      caps->InsertNextTuple2(model.Settings.Caps.Stiffness, model.Settings.Caps.Damping);
    }
    basics.Append(model, s.Time, s.Record);
    AddVector(tip, s.Record.Tip);
    AddVector(command, model.DeviceToWorldRotation * s.Command);
    tick->InsertNextValue(static_cast<vtkIdType>(s.Tick));
    enabled->InsertNextValue(s.Before.Enabled ? 0 : 1);
    placement->InsertNextValue(entry->second);
    buttons->InsertNextValue(static_cast<int>(s.Buttons));
    armed->InsertNextValue(s.Armed ? 1 : 0);
    fault->InsertNextValue(static_cast<unsigned char>(s.Fault));
  }
  basics.WriteTo(trace);
  return trace;
}

} // namespace VolumeHaptics
