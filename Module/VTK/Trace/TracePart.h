// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Consecutive ticks of a path, on their way into the trace.
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
  /** `work` goes on from one part of a path to the next. */
  TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work);

  /** The record that Append() takes; to be written whole before that. */
  TickRecord& GetNext() { return this->Records[this->Filled]; }
  /** `forces` are those of the modes, on device axes, if the trace has any. */
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
  /** Writes the rest of a block. */
  void Flush();

private:
  /** Takes over the next record, which a tick on another model has made. */
  void Replace(const std::shared_ptr<const HapticModel>& model);
  void WriteModeForces(const ModeForces& forces);

  const HapticTrace& Trace;
  vtkIdType Next;
  std::size_t Filled = 0;
  std::shared_ptr<const HapticModel> Model; ///< of the records
  std::array<TickRecord, FewRecords> Records;
  std::array<double, FewRecords> Times; ///< s
  WorkMeter& Work;
};

} // namespace VolumeHaptics

#endif
