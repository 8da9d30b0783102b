// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Consecutive ticks of a path, on their way into the trace.
 */
#ifndef TracePart_h
#define TracePart_h

#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "VTK/Trace/TraceRow.h"

#include "vtkType.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

class HapticTrace;

/**
 * Collects records in device space, transforms them into the world of the model's image, and writes
 * them to the trace's memory, a block at a time, column by column: tuples of all columns at once
 * would compete for the same few lines of the cache. Parts may be written by several threads.
 */
class TracePart
{
public:
  /** `work` goes on from one part of a path to the next. */
  TracePart(const HapticTrace& trace, vtkIdType firstRow, WorkMeter& work);

  /** `forces` are those of the modes, on device axes, if the trace has any. */
  void Append(const HapticModel& model, double time, const TickRecord& record,
    const ModeForces* forces = nullptr);
  /** Writes the rest of a block. */
  void Flush();

private:
  static constexpr std::size_t BlockSize = 64;

  const HapticTrace& Trace;
  vtkIdType Next;
  std::size_t Filled = 0;
  std::array<TraceRow, BlockSize> Block;
  std::array<long long, BlockSize> Labels;
  WorkMeter& Work;
};

} // namespace VolumeHaptics

#endif
