// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceRecords.h"

#include "VTK/Trace/HapticTrace.h"

namespace VolumeHaptics
{
namespace
{

/** Writes the records of a block to a trace's columns; some columns may not be chosen. */
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
  /** Writes a number for each record, computed from the record and its index in the block. */
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

  /** Returns the first tuple of a member's column; null if there is none. */
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
  // Copies: for the compiler, writing to the columns could change the originals.
  const Affine3 ToWorld;
  const Matrix3 Rotation;
  const TickRecord* const Records;
  const std::size_t Count;
  const vtkIdType FirstRow;
};

} // namespace

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

} // namespace VolumeHaptics
