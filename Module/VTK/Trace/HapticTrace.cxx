// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/HapticTrace.h"

#include "Core/Model/HapticModel.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Tools/ToolArrays.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLongLongArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <numeric>
#include <vector>

namespace VolumeHaptics
{
namespace
{

vtkSmartPointer<vtkDataArray> NewArray(const TraceColumn& column, vtkIdType ticks)
{
  vtkSmartPointer<vtkDataArray> array;
  if (column.Type == ColumnType::UInt8)
  {
    array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  }
  else
  {
    array = vtkSmartPointer<vtkDoubleArray>::New();
  }
  array->SetName(column.Name);
  array->SetNumberOfComponents(column.Components);
  AllocateTuples(array, ticks);
  return array;
}

/** Makes one polyline per path for points that are stored path after path without gaps. */
vtkSmartPointer<vtkCellArray> NewLines(const std::vector<HapticTrace::Rows>& paths, vtkIdType ticks)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(paths.size()) + 1);
  vtkIdType end = 0;
  offsets->SetValue(0, end);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    end += paths[i].Count;
    offsets->SetValue(static_cast<vtkIdType>(i) + 1, end);
  }
  vtkNew<vtkIdTypeArray> points;
  AllocateTuples(points, ticks);
  std::iota(points->GetPointer(0), points->GetPointer(0) + ticks, vtkIdType(0));
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  lines->SetData(offsets, points);
  return lines;
}

/** Writes the records of a block to the chosen columns of a trace. */
class ColumnWriter
{
public:
  ColumnWriter(const HapticTrace& trace, const HapticModel& model, const TickRecord* records,
    std::size_t count, vtkIdType firstRow)
    : Trace(trace)
    , ToWorld(model.DeviceToWorld)
    , Rotation(model.DeviceToWorldRotation)
    , Records(records)
    , Count(count)
    , FirstRow(firstRow)
  {
  }

  void Point(double (TraceRow::*to)[3], Vector3 TickRecord::*from) const
  {
    this->Vectors(to, [=](const TickRecord& record) { return this->ToWorld(record.*from); });
  }
  void Direction(double (TraceRow::*to)[3], Vector3 TickRecord::*from) const
  {
    this->Vectors(to, [=](const TickRecord& record) { return this->Rotation * (record.*from); });
  }
  void Number(double TraceRow::*to, double TickRecord::*from) const
  {
    this->Numbers(to, [=](std::size_t i) { return this->Records[i].*from; });
  }
  template <typename Member>
  void Byte(unsigned char TraceRow::*to, Member from) const
  {
    this->Numbers(
      to, [=](std::size_t i) { return static_cast<unsigned char>(this->Records[i].*from); });
  }
  /** Writes a number per record, computed from the record and its index in the block. */
  template <typename Value, typename Function>
  void Numbers(Value TraceRow::*to, const Function& function) const
  {
    if (Value* const column = this->Find<Value>(to))
    {
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        column[i] = function(i);
      }
    }
  }

private:
  template <typename Function>
  void Vectors(double (TraceRow::*to)[3], const Function& function) const
  {
    if (double* column = this->Find<double, 3>(to))
    {
      for (std::size_t i = 0; i < this->Count; ++i, column += 3)
      {
        const Vector3 vector = function(this->Records[i]);
        column[0] = vector.X;
        column[1] = vector.Y;
        column[2] = vector.Z;
      }
    }
  }

  /**
   * Returns the address of the block's tuples in a member's column; null if the column is not
   * chosen.
   */
  template <typename Value, int Components = 1, typename Member>
  Value* Find(Member member) const
  {
    static const TraceRow row{};
    const auto* const begin = reinterpret_cast<const unsigned char*>(&row);
    const auto* const at = reinterpret_cast<const unsigned char*>(&(row.*member));
    unsigned char* const tuples = this->Trace.GetColumn(static_cast<std::size_t>(at - begin));
    return tuples ? reinterpret_cast<Value*>(tuples) + Components * this->FirstRow : nullptr;
  }

  const HapticTrace& Trace;
  // Copies, because the compiler would otherwise assume that writing to the columns changes the
  // originals.
  const Affine3 ToWorld;
  const Matrix3 Rotation;
  const TickRecord* const Records;
  const std::size_t Count;
  const vtkIdType FirstRow;
};

/**
 * Writes at most FewRecords records of ticks on one model, column by column. Writing all columns at
 * once would be slower, because their tuples compete for the same few cache lines, and each record
 * needs all maps at once. `work` continues from the previous records.
 */
void WriteRecords(const HapticTrace& trace, const HapticModel& model, const TickRecord* records,
  const double* times, std::size_t count, vtkIdType firstRow, WorkMeter& work)
{
  const ColumnWriter columns(trace, model, records, count, firstRow);
  VisitTraceSources(columns);
  columns.Numbers(&TraceRow::Time, [=](std::size_t i) { return times[i]; });
  columns.Numbers(&TraceRow::Energy, [&](std::size_t i) { return work.Add(records[i]); });
  columns.Numbers(
    &TraceRow::DataTime, [&](std::size_t i) { return GetTraceDataTime(model, records[i]); });
  columns.Numbers(
    &TraceRow::Value, [&](std::size_t i) { return GetTraceValue(model, records[i]); });
  for (const HapticTrace::ToolArray& array : trace.GetArraysOfTool())
  {
    const int width = array.Column->Components;
    double* numbers = array.Numbers + width * firstRow;
    for (std::size_t i = 0; i < count; ++i, numbers += width)
    {
      array.Column->Read(model, records[i], numbers);
    }
  }
  if (long long* const labels = trace.GetLabels())
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      labels[firstRow + static_cast<vtkIdType>(i)] = GetTraceLabel(model, records[i]);
    }
  }
}

} // namespace

HapticTrace::HapticTrace(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume)
{
  this->Proxies->SetDataTypeToDouble();
  AllocateTuples(this->Proxies->GetData(), ticks);
  const auto remember = [this](vtkDataArray* array, std::size_t offset)
  { this->Columns[offset] = static_cast<unsigned char*>(array->GetVoidPointer(0)); };
  remember(this->Proxies->GetData(), offsetof(TraceRow, Proxy));
  std::vector<TraceColumn> columns = GetTraceColumns();
  const std::size_t labelArray = columns.size();
  if (volume.IsMoving())
  {
    columns.push_back({ DataTimeColumn, "", ColumnType::Float64, 1, offsetof(TraceRow, DataTime) });
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    if (IsChosen(choice, i < labelArray ? i : labelArray + 1))
    {
      this->Arrays.push_back(NewArray(columns[i], ticks));
      remember(this->Arrays.back(), columns[i].Offset);
    }
  }
  if (volume.Labels && ticks > 0 && IsChosen(choice, labelArray))
  {
    vtkNew<vtkLongLongArray> labels;
    labels->SetName(LabelColumn);
    AllocateTuples(labels, ticks);
    this->LabelNumbers = labels->GetPointer(0);
    this->Arrays.emplace_back(labels.Get());
  }
  const std::size_t modes = std::min(volume.Modes.size(), MostModeForces);
  for (std::size_t mode = 0; mode < modes; ++mode)
  {
    const std::size_t array = GetModeForceArray(mode);
    if (IsChosen(choice, array))
    {
      this->Arrays.push_back(
        NewArray({ GetTraceArrayName(array), "", ColumnType::Float64, 3, 0 }, ticks));
      this->ModeNumbers.resize(modes);
      this->ModeNumbers[mode] = static_cast<double*>(this->Arrays.back()->GetVoidPointer(0));
    }
  }
  if (volume.Tool)
  {
    this->AddToolArrays(ticks, choice, volume);
  }
}

HapticTrace::~HapticTrace() = default;

void HapticTrace::AddToolArrays(vtkIdType ticks, TraceArrayChoice choice, const BakedVolume& volume)
{
  const auto add = [=](const TraceColumn& column, std::size_t index) -> double*
  {
    if (!IsChosen(choice, GetToolArray(index)))
    {
      return nullptr;
    }
    this->Arrays.push_back(NewArray(column, ticks));
    return static_cast<double*>(this->Arrays.back()->GetVoidPointer(0));
  };
  constexpr ColumnType number = ColumnType::Float64;
  this->OrientationNumbers = add({ CommonToolArrays[0], "", number, 4, 0 }, 0);
  constexpr std::size_t torque = offsetof(TraceRow, Torque);
  this->Columns[torque] =
    reinterpret_cast<unsigned char*>(add({ CommonToolArrays[1], "", number, 3, torque }, 1));
  const auto addOfTool = [&](const ToolColumn& column, std::size_t index)
  {
    double* const numbers = add({ column.Name, column.Unit, number, column.Components, 0 }, index);
    if (numbers)
    {
      this->ToolArrays.push_back({ &column, numbers });
    }
  };
  static const ToolColumn depth{ CommonToolArrays[2], "", 1, false,
    [](const HapticModel& model, const TickRecord& record, double* numbers)
    { numbers[0] = model.WorldUnitsPerMeter * record.Depth; } };
  static const ToolColumn shaft{ CommonToolArrays[3], "", 1, false,
    [](const HapticModel&, const TickRecord& record, double* numbers)
    { numbers[0] = record.ShaftForce; } };
  addOfTool(depth, 2);
  addOfTool(shaft, 3);
  const ToolColumns& own = volume.Tool->GetColumns();
  std::size_t index = std::size(CommonToolArrays);
  for (const ToolColumn* const array : GetToolArrays())
  {
    const auto found = std::find_if(own.begin(), own.end(),
      [array](const ToolColumn& column) { return std::strcmp(column.Name, array->Name) == 0; });
    if (found != own.end())
    {
      addOfTool(*found, index);
    }
    ++index;
  }
}

void HapticTrace::CloseGaps(const std::vector<Rows>& paths)
{
  const auto move = [&paths](vtkDataArray* array)
  {
    auto* const tuples = static_cast<unsigned char*>(array->GetVoidPointer(0));
    const auto width = static_cast<std::size_t>(array->GetNumberOfComponents()) *
      static_cast<std::size_t>(array->GetDataTypeSize());
    vtkIdType end = 0;
    for (const Rows& rows : paths)
    {
      if (end != rows.First)
      {
        std::memmove(tuples + end * width, tuples + rows.First * width, rows.Count * width);
      }
      end += rows.Count;
    }
  };
  move(this->Proxies->GetData());
  for (vtkDataArray* const array : this->Arrays)
  {
    move(array);
  }
}

void HapticTrace::WriteTo(vtkPolyData* output, const std::vector<Rows>& paths, bool areSeveral)
{
  const vtkIdType ticks = std::accumulate(paths.begin(), paths.end(), vtkIdType(0),
    [](vtkIdType sum, const Rows& rows) { return sum + rows.Count; });
  if (ticks < this->Proxies->GetNumberOfPoints())
  {
    this->CloseGaps(paths);
    this->Proxies->GetData()->SetNumberOfTuples(ticks);
    for (vtkDataArray* const array : this->Arrays)
    {
      array->SetNumberOfTuples(ticks);
    }
  }
  output->SetPoints(this->Proxies);
  if (areSeveral || ticks > 1)
  {
    output->SetLines(NewLines(paths, ticks));
  }
  for (vtkDataArray* const array : this->Arrays)
  {
    output->GetPointData()->AddArray(array);
  }
}

TracePart::TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work)
  : Trace(trace)
  , Next(firstRow)
  , Work(work)
{
}

void TracePart::Replace(const std::shared_ptr<const HapticModel>& model)
{
  const TickRecord record = this->GetNext();
  this->Flush();
  this->GetNext() = record;
  this->Model = model;
}

void TracePart::WriteModeForces(const ModeForces& forces)
{
  const std::vector<double*>& columns = this->Trace.GetModeForces();
  const vtkIdType row = this->Next + static_cast<vtkIdType>(this->Filled);
  for (std::size_t mode = 0; mode < columns.size(); ++mode)
  {
    if (columns[mode])
    {
      const Vector3 force = this->Model->DeviceToWorldRotation * forces[mode];
      double* const to = columns[mode] + 3 * row;
      to[0] = force.X;
      to[1] = force.Y;
      to[2] = force.Z;
    }
  }
}

void TracePart::Flush()
{
  if (this->Filled == 0)
  {
    return;
  }
  WriteRecords(this->Trace, *this->Model, this->Records.data(), this->Times.data(), this->Filled,
    this->Next, this->Work);
  this->Next += static_cast<vtkIdType>(this->Filled);
  this->Filled = 0;
}

} // namespace VolumeHaptics
