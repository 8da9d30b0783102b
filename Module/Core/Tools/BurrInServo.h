// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A burr in the servo: see Burr/BurrTool.h.
 *
 * Its centre is at the device's tip. Its head has its size in the world, like a tool with a shape
 * (ShellTool.h); forces, energies and volumes are in the hand's space.
 */
#ifndef BurrInServo_h
#define BurrInServo_h

#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{
class ToolMemory;

/**
 * One tick, HapticSettings::TickPeriod long, of a model's burr. The proxy is the centre of the
 * head. Writes to BakedVolume::Removal.
 */
void StepBurr(
  const HapticModel& model, ServoState& state, ToolMemory& tool, TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
