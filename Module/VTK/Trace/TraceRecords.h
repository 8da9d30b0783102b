// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes records in device space to a trace's memory in the world.
 */
#ifndef TraceRecords_h
#define TraceRecords_h

#include "Core/Model/HapticModel.h"
#include "Core/State/TickRecord.h"
#include "VTK/Trace/TraceRow.h"

#include "vtkType.h"

#include <cstddef>

namespace VolumeHaptics
{

class HapticTrace;

/** Number of records that stay in the cache beside all that a tick reads. */
constexpr std::size_t FewRecords = 32;

/**
 * Writes at most FewRecords records of ticks on one model, column by column: tuples of all columns
 * at once would compete for the same few lines of the cache, and each record would need all maps at
 * once. `work` continues from the records before.
 */
void WriteRecords(const HapticTrace& trace, const HapticModel& model, const TickRecord* records,
  const double* times, std::size_t count, vtkIdType firstRow, WorkMeter& work);

} // namespace VolumeHaptics

#endif
