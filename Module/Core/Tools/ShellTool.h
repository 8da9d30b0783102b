// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tool with a shape in the servo: see PointShell/ShellCoupling.h for what it does.
 *
 * Its frame is that of the stylus: the origin at the device's tip, the axes those of the stylus. It
 * has its size in the world, so that it is as large as it is drawn, whatever the device's placement
 * is. A device that measures no orientation holds it as it was held last.
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

/** A tick of the tool of a model that has one. The proxy is the origin of the tool. */
void StepShell(
  const HapticModel& model, ServoState& state, ShellMemory& memory, TickRecord& record) noexcept;

/** What the record of a tick, and the state of the method, have of a tool with a shape. */
void WriteShellRecord(const HapticModel& model, ServoState& state, const ShellRecord& felt,
  TickRecord& record) noexcept;

/** N m/rad, of the spring that turns the hand; 0 without such a tool. */
inline double FindTurningStiffness(const HapticModel& model) noexcept
{
  return model.Baked->HasTool(ToolKind::Shell) ? model.Baked->Tool->ShellTouch.TurningStiffness
                                               : 0.0;
}

/**
 * Takes the tool along to another model, if that has the same. Otherwise the hand begins anew, with
 * no force; so does a point that follows a tool with a shape.
 */
void CarryShellTool(
  const HapticModel& from, const HapticModel& to, ServoState& state, ToolMemory* tool) noexcept;

} // namespace VolumeHaptics

#endif
