// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/ShellTool.h"

#include "Core/Tools/PointShell/ShellCarry.h"
#include "Core/Tools/ToolMemory.h"

namespace VolumeHaptics
{
namespace
{

ContactState FindContact(const ShellRecord& felt) noexcept
{
  if (felt.Contacts == 0)
  {
    return ContactState::Free;
  }
  return felt.Yielding == felt.Contacts ? ContactState::Penetrating : ContactState::Sticking;
}

} // namespace

void StepShell(
  const HapticModel& model, ServoState& state, ShellMemory& memory, TickRecord& record) noexcept
{
  const BakedTool& tool = *model.Baked->Tool;
  const bool isKnown = state.HasOrientation || !state.Shell.Enabled;
  const ShellPose hand{ record.Tip, isKnown ? state.Orientation : state.Shell.Hand.Orientation };
  ShellRecord felt;
  TickShell(model, *tool.Shell, FindShellSettings(model), hand, state.Shell, memory, felt);
  WriteShellRecord(model, state, felt, record);
}

void WriteShellRecord(
  const HapticModel& model, ServoState& state, const ShellRecord& felt, TickRecord& record) noexcept
{
  // The method does not tick: set where it would go on, and what it would read.
  state.Precise.ReachedTip = record.Tip;
  const double norm = Norm(felt.Force);
  record.Proxy = felt.Tool.Position;
  record.ToolOrientation = felt.Tool.Orientation;
  record.HandOrientation = felt.Hand.Orientation;
  record.Force = felt.Force;
  record.Torque = felt.Torque;
  record.Normal = norm > 0.0 ? (-1.0 / norm) * felt.Force : model.FallbackNormal;
  record.NormalForce = norm;
  record.Stiffness = felt.Stiffness;
  record.GradientMagnitude = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  record.SurfaceValue = record.MediumValue = model.ValueAtDevice(record.Proxy);
  record.Contact = FindContact(felt);
  record.IsUnfinished = felt.IsUnfinished;
}

void CarryShellTool(
  const HapticModel& from, const HapticModel& to, ServoState& state, ToolMemory* tool) noexcept
{
  const bool wasShell = from.Baked->HasShape();
  const bool isShell = to.Baked->HasShape();
  CarryShell(from, to, state.Shell, tool ? tool->GetShell() : nullptr);
  // A burr starts removal anew.
  state.Burr = BurrState{};
  if ((wasShell || isShell) && !state.Shell.Enabled)
  {
    state.Enabled = false;
  }
}

} // namespace VolumeHaptics
