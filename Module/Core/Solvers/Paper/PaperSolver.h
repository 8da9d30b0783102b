// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The solver as published, with one gradient and one evaluation of the material law in each tick
 * (sections 3.2 to 3.4 of the paper).
 */
#ifndef PaperSolver_h
#define PaperSolver_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Computes a tick for record.Tip. Writes the whole record and the memory of labels. */
void StepPaper(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept;

/** Implements Method::Reach. */
Vector3 FindPaperReach(const HapticModel& model) noexcept;

} // namespace VolumeHaptics

#endif
