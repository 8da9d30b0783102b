// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/BakedShell.h"

#include "Core/State/ServoState.h"
#include "Core/Tools/PointShell/ShellCarry.h"

#include <typeinfo>
#include <utility>

namespace VolumeHaptics
{
namespace
{

ContactState ComputeContact(const ShellRecord& felt) noexcept
{
  if (felt.Contacts == 0)
  {
    return ContactState::Free;
  }
  return felt.Yielding == felt.Contacts ? ContactState::Penetrating : ContactState::Sticking;
}

} // namespace

const ShapedTool* ShapedTool::Find(const BakedVolume& baked) noexcept
{
  return dynamic_cast<const ShapedTool*>(baked.Tool.get());
}

ShapedTool::ShapedTool(ShellDescription description)
  : Description(std::move(description))
{
}

bool ShapedTool::IsSame(const BakedTool& other) const
{
  if (typeid(*this) != typeid(other))
  {
    return false;
  }
  const ShellDescription& a = this->Description;
  const ShellDescription& b = static_cast<const ShapedTool&>(other).Description;
  return a.Points == b.Points && a.Touch.Level == b.Touch.Level &&
    a.Touch.IsBelow == b.Touch.IsBelow && a.Touch.ContactArea == b.Touch.ContactArea &&
    a.Touch.CouplingStiffness == b.Touch.CouplingStiffness &&
    a.Touch.TurningStiffness == b.Touch.TurningStiffness;
}

bool ShapedTool::Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
  ToolMemory* memory) const noexcept
{
  auto* const shaped = dynamic_cast<ShapedMemory*>(memory);
  CarryShell(from, to, state.Shell, shaped ? &shaped->Shell : nullptr);
  this->Begin(state);
  return false;
}

void ShapedTool::Begin(ServoState& state) const noexcept
{
  state.Enabled = state.Enabled && state.Shell.Enabled;
}

std::shared_ptr<ToolMemory> ShapedTool::MakeMemory(const std::shared_ptr<ToolMemory>& last) const
{
  const auto* const shaped = dynamic_cast<const ShapedMemory*>(last.get());
  return shaped && shaped->Points == this->Description.Points
    ? last
    : std::make_shared<ShapedMemory>(this->Description.Points);
}

void ShapedTool::AppendTables(std::vector<MemoryRange>& tables) const
{
  const PointShell& shell = *this->Description.Points;
  const std::size_t numbers = shell.GetSize() * sizeof(double);
  const auto& blocks = shell.GetBlocks();
  tables.push_back({ this, sizeof(*this) });
  tables.push_back({ &shell, sizeof(shell) });
  tables.push_back({ blocks.data(), blocks.size() * sizeof(blocks[0]) });
  for (const double* const each : { shell.GetX(), shell.GetY(), shell.GetZ(), shell.GetAreas() })
  {
    tables.push_back({ each, numbers });
  }
}

void ShapedTool::WriteRecord(const ToolTick& tick, const ShellRecord& felt) noexcept
{
  TickRecord& record = tick.Record;
  // The method computes no tick. Set the state from which it would continue, and the values that it
  // would read.
  tick.State.Precise.ReachedTip = record.Tip;
  const double norm = Norm(felt.Force);
  record.Proxy = felt.Tool.Position;
  record.ToolOrientation = felt.Tool.Orientation;
  record.HandOrientation = felt.Hand.Orientation;
  record.Force = felt.Force;
  record.Torque = felt.Torque;
  record.Normal = norm > 0.0 ? (-1.0 / norm) * felt.Force : tick.Model.FallbackNormal;
  record.NormalForce = norm;
  record.Stiffness = felt.Stiffness;
  record.GradientMagnitude = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  record.SurfaceValue = record.MediumValue = tick.Model.ValueAtDevice(record.Proxy);
  record.Contact = ComputeContact(felt);
  record.IsUnfinished = felt.IsUnfinished;
}

ShapedMemory::ShapedMemory(std::shared_ptr<const PointShell> points)
  : Points(std::move(points))
  , Shell(*this->Points)
{
}

std::vector<MemoryRange> ShapedMemory::GetTables() const
{
  std::vector<MemoryRange> tables{ { this, sizeof(*this) } };
  this->Shell.AppendTables(tables);
  return tables;
}

BakedShell::BakedShell(ShellDescription description)
  : ShapedTool(std::move(description))
{
}

const ToolColumns& BakedShell::Columns()
{
  // Never destroyed, because a filter may live until the process ends.
  static const auto* const columns = new ToolColumns{ { "ToolOrientation", "", 4, true,
    [](const HapticModel& model, const TickRecord& record, double* numbers)
    {
      const Quaternion& q = record.ToolOrientation;
      const Quaternion world =
        TurnedBy(model.DeviceToWorldRotation, q, !IsIdentical(q, NoOrientation));
      numbers[0] = world.W;
      numbers[1] = world.X;
      numbers[2] = world.Y;
      numbers[3] = world.Z;
    } } };
  return *columns;
}

bool BakedShell::Step(const ToolTick& tick) const noexcept
{
  if (!tick.Memory)
  {
    tick.FeelPoint();
    return false;
  }
  ServoState& state = tick.State;
  const bool isKnown = state.HasOrientation || !state.Shell.Enabled;
  const ShellPose hand{ tick.Record.Tip,
    isKnown ? state.Orientation : state.Shell.Hand.Orientation };
  ShellRecord felt;
  TickShell(tick.Model, *this->Description.Points, ComputeShellSettings(tick.Model), hand,
    state.Shell, static_cast<ShapedMemory*>(tick.Memory)->Shell, felt);
  WriteRecord(tick, felt);
  return false;
}

const ShellContacts* FindKeptContacts(const ToolMemory* memory) noexcept
{
  const auto* const shaped = dynamic_cast<const ShapedMemory*>(memory);
  return shaped ? &shaped->Shell.GetKept() : nullptr;
}

bool RestoreContacts(ToolMemory& memory, const BakedVolume& baked,
  const std::vector<ShellContact>& contacts, double fraction)
{
  auto* const shaped = dynamic_cast<ShapedMemory*>(&memory);
  const ShapedTool* const tool = ShapedTool::Find(baked);
  if (!shaped || !tool || tool->Description.Points != shaped->Points ||
    !shaped->Shell.Restore(contacts, fraction))
  {
    return false;
  }
  shaped->Shell.Model = baked.Number;
  return true;
}

} // namespace VolumeHaptics
