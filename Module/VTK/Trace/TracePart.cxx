// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TracePart.h"

#include "VTK/Trace/HapticTrace.h"

#include <vector>

namespace VolumeHaptics
{

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
