// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tool with a shape in the servo: see PointShell/ShellCoupling.h.
 *
 * Its frame is the stylus's: the origin at the device's tip, the axes those of the stylus. It has
 * its size in the world, so that it is as large as it is drawn, for any placement of the device. If
 * the device measures no orientation, the tool keeps its last one.
 */
#ifndef ShellTool_h
#define ShellTool_h

#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{
class ShellMemory;
class ToolMemory;
struct ShellRecord;

/** One tick of a model's tool. The proxy is the origin of the tool. */
void StepShell(
  const HapticModel& model, ServoState& state, ShellMemory& memory, TickRecord& record) noexcept;

/** Writes a tool with a shape to the record of a tick, and to the state of the method. */
void WriteShellRecord(const HapticModel& model, ServoState& state, const ShellRecord& felt,
  TickRecord& record) noexcept;

/** N m/rad, the spring that turns the hand; 0 without such a tool. */
inline double FindTurningStiffness(const HapticModel& model) noexcept
{
  return model.Baked->HasTool(ToolKind::Shell) ? model.Baked->Tool->ShellTouch.TurningStiffness
                                               : 0.0;
}

/**
 * Carries the tool to another model with the same tool. Otherwise the hand begins anew, with no
 * force; so does a point that follows a tool with a shape.
 */
void CarryShellTool(
  const HapticModel& from, const HapticModel& to, ServoState& state, ToolMemory* tool) noexcept;

} // namespace VolumeHaptics

#endif
