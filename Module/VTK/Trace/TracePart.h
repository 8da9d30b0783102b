// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Passes consecutive ticks of a path to the trace.
 */
#ifndef TracePart_h
#define TracePart_h

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "Core/State/TickRecord.h"
#include "VTK/Trace/TraceRecords.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>

namespace VolumeHaptics
{

class HapticTrace;

/**
 * Collects a few records, and writes them to the trace on the same thread. Parts may be written by
 * several threads.
 */
class TracePart
{
public:
  /** `work` carries its sum from one part of a path to the next. */
  TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work);

  /** Returns the record that Append() adds; write all of it before. */
  TickRecord& GetNext() { return this->Records[this->Filled]; }
  /** Adds the record. `forces` are the modes' forces on device axes, if the trace has any. */
  void Append(const std::shared_ptr<const HapticModel>& model, double time,
    const ModeForces* forces = nullptr)
  {
    if (this->Model != model)
    {
      this->Replace(model);
    }
    if (forces)
    {
      this->WriteModeForces(*forces);
    }
    this->Times[this->Filled] = time;
    if (++this->Filled == FewRecords)
    {
      this->Flush();
    }
  }
  /** Writes the remaining records. */
  void Flush();

private:
  /** Makes the next record belong to another model, which made its tick. */
  void Replace(const std::shared_ptr<const HapticModel>& model);
  void WriteModeForces(const ModeForces& forces);

  const HapticTrace& Trace;
  vtkIdType Next;
  std::size_t Filled = 0;
  std::shared_ptr<const HapticModel> Model; ///< model of the records
  std::array<TickRecord, FewRecords> Records;
  std::array<double, FewRecords> Times; ///< s
  WorkMeter& Work;
};

} // namespace VolumeHaptics

#endif
