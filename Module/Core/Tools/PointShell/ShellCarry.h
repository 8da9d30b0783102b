// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Moves a tool with a shape from one model to the next.
 */
#ifndef ShellCarry_h
#define ShellCarry_h

#include "Core/Tools/PointShell/ShellCoupling.h"

namespace VolumeHaptics
{

/**
 * Moves the tool and its contacts to another material, other settings, or another placement of the
 * device. The contacts rest on the volume: if the volume moves under the hand, the tool moves with
 * it, and each contact keeps at most its energy. If the springs become stiffer, the tool begins
 * nearer to the hand, so that they have no more energy than before. If the shell or the volume is
 * another one, the state is disabled: the tool begins in the hand, without a force.
 */
void CarryShell(
  const HapticModel& from, const HapticModel& to, ShellState& state, ShellMemory* memory) noexcept;

} // namespace VolumeHaptics

#endif
