// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TracePart.h"

#include "VTK/Trace/HapticTrace.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Copies a member of rows to a column of tuples. As numbers: compilers make of the same with bytes
 * what stalls the processor at every second one.
 */
template <typename Number, int Components>
void CopyColumn(const TraceRow* rows, std::size_t count, std::size_t offset, unsigned char* column)
{
  const auto* from = reinterpret_cast<const unsigned char*>(rows) + offset;
  auto* to = reinterpret_cast<Number*>(column);
  for (std::size_t i = 0; i < count; ++i, from += sizeof(TraceRow), to += Components)
  {
    const auto* const numbers = reinterpret_cast<const Number*>(from);
    for (int c = 0; c < Components; ++c)
    {
      to[c] = numbers[c];
    }
  }
}

} // namespace

TracePart::TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work)
  : Trace(trace)
  , Next(firstRow)
  , Work(work)
{
}

void TracePart::Append(
  const HapticModel& model, double time, const TickRecord& record, const ModeForces* forces)
{
  const std::vector<double*>& columns = this->Trace.GetModeForces();
  for (std::size_t mode = 0; forces && mode < columns.size(); ++mode)
  {
    if (columns[mode])
    {
      const Vector3 force = model.DeviceToWorldRotation * (*forces)[mode];
      double* const to = columns[mode] + 3 * (this->Next + static_cast<vtkIdType>(this->Filled));
      to[0] = force.X;
      to[1] = force.Y;
      to[2] = force.Z;
    }
  }
  TraceRow& row = this->Block[this->Filled];
  if (this->Trace.HasValues())
  {
    FillTraceRow(model, time, record, this->Work, row);
  }
  else
  {
    FillTraceRowWithoutValue(model, time, record, this->Work, row);
  }
  if (this->Trace.GetLabels())
  {
    this->Labels[this->Filled] = GetTraceLabel(model, record);
  }
  if (++this->Filled == BlockSize)
  {
    this->Flush();
  }
}

void TracePart::Flush()
{
  for (const TraceMemory& column : this->Trace.GetMemory())
  {
    unsigned char* const tuples = column.Tuples + this->Next * column.Width;
    if (column.Width == sizeof(double))
    {
      CopyColumn<double, 1>(this->Block.data(), this->Filled, column.Offset, tuples);
    }
    else if (column.Width == 1)
    {
      CopyColumn<unsigned char, 1>(this->Block.data(), this->Filled, column.Offset, tuples);
    }
    else
    {
      CopyColumn<double, 3>(this->Block.data(), this->Filled, column.Offset, tuples);
    }
  }
  if (long long* const labels = this->Trace.GetLabels())
  {
    std::copy_n(this->Labels.begin(), this->Filled, labels + this->Next);
  }
  this->Next += static_cast<vtkIdType>(this->Filled);
  this->Filled = 0;
}

} // namespace VolumeHaptics
