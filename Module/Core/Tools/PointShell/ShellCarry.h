// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tool with a shape from one model to the next.
 */
#ifndef ShellCarry_h
#define ShellCarry_h

#include "Core/Tools/PointShell/ShellCoupling.h"

namespace VolumeHaptics
{

/**
 * Takes the tool and its contacts to another material, other settings, or another placement of the
 * device. The contacts rest on the volume: if it moves under the hand, so does the tool, and each
 * contact keeps its energy at most. Stiffer springs find the tool nearer to the hand, so that they
 * have no more energy. With another shell or another volume, the state is disabled: the tool begins
 * in the hand with no force.
 */
void CarryShell(
  const HapticModel& from, const HapticModel& to, ShellState& state, ShellMemory* memory) noexcept;

} // namespace VolumeHaptics

#endif
