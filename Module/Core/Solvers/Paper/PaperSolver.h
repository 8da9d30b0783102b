// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The solver as published: one gradient and one evaluation of the material law per tick, sections
 * 3.2 to 3.4 of the paper.
 */
#ifndef PaperSolver_h
#define PaperSolver_h

namespace VolumeHaptics
{
class HapticModel;
struct ServoState;
struct TickMemory;
struct TickRecord;

/** One tick from record.Tip; writes all of the record, and the memory of labels. */
void StepPaper(
  const HapticModel& model, ServoState& state, TickRecord& record, TickMemory* memory) noexcept;

} // namespace VolumeHaptics

#endif
