// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TracePart.h"

#include "VTK/Trace/HapticTrace.h"

#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Writes the records of a block to a trace's columns, of which some may not be chosen. */
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
  /** A number of the record with an index in the block. */
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

  /** The first tuple of a member's column; null if there is none. */
  template <typename Value, int Components = 1, typename Member>
  Value* Find(Member member) const
  {
    static const TraceRow row{};
    const auto* const begin = reinterpret_cast<const unsigned char*>(&row);
    const auto* const at = reinterpret_cast<const unsigned char*>(&(row.*member));
    unsigned char* const tuples = this->Trace.FindColumn(static_cast<std::size_t>(at - begin));
    return tuples ? reinterpret_cast<Value*>(tuples) + Components * this->FirstRow : nullptr;
  }

  const HapticTrace& Trace;
  // Copies, which what is written cannot change, as far as the compiler knows.
  const Affine3 ToWorld;
  const Matrix3 Rotation;
  const TickRecord* const Records;
  const std::size_t Count;
  const vtkIdType FirstRow;
};

} // namespace

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
  const HapticModel& model = *this->Model;
  const ColumnWriter columns(this->Trace, model, this->Records.data(), this->Filled, this->Next);
  VisitTraceSources(columns);
  columns.Numbers(&TraceRow::Time, [this](std::size_t i) { return this->Times[i]; });
  columns.Numbers(
    &TraceRow::Energy, [this](std::size_t i) { return this->Work.Add(this->Records[i]); });
  columns.Numbers(
    &TraceRow::DataTime, [&](std::size_t i) { return GetTraceDataTime(model, this->Records[i]); });
  columns.Numbers(&TraceRow::Value,
    [&](std::size_t i)
    { return model.ValueAtDevice(this->Records[i].Proxy, this->Records[i].DataTime); });
  if (long long* const labels = this->Trace.GetLabels())
  {
    for (std::size_t i = 0; i < this->Filled; ++i)
    {
      labels[this->Next + static_cast<vtkIdType>(i)] = GetTraceLabel(model, this->Records[i]);
    }
  }
  this->Next += static_cast<vtkIdType>(this->Filled);
  this->Filled = 0;
}

} // namespace VolumeHaptics
