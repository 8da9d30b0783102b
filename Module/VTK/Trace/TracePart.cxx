// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TracePart.h"

#include "VTK/Trace/HapticTrace.h"

#include <algorithm>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

/** Copies a member of this many bytes from rows to a column. */
template <std::size_t Width>
void CopyColumn(const TraceRow* rows, std::size_t count, std::size_t offset, unsigned char* column)
{
  const auto* from = reinterpret_cast<const unsigned char*>(rows) + offset;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::memcpy(column + i * Width, from + i * sizeof(TraceRow), Width);
  }
}

} // namespace

TracePart::TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work)
  : Trace(trace)
  , Next(firstRow)
  , Work(work)
{
}

void TracePart::Append(const HapticModel& model, double time, const TickRecord& record)
{
  this->Block[this->Filled] =
    MakeTraceRow(model, time, record, this->Work, this->Trace.HasValues());
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
      CopyColumn<sizeof(double)>(this->Block.data(), this->Filled, column.Offset, tuples);
    }
    else if (column.Width == 1)
    {
      CopyColumn<1>(this->Block.data(), this->Filled, column.Offset, tuples);
    }
    else
    {
      CopyColumn<3 * sizeof(double)>(this->Block.data(), this->Filled, column.Offset, tuples);
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
