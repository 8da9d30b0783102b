// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/BakedShell.h"

#include "Core/State/ServoState.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

bool IsSameVolume(const BakedVolume& from, const BakedVolume& to) noexcept
{
  const VolumeView& a = from.Field.GetView();
  const VolumeView& b = to.Field.GetView();
  return a.Data == b.Data && a.Type == b.Type &&
    std::equal(std::begin(a.Dimensions), std::end(a.Dimensions), std::begin(b.Dimensions)) &&
    IsIdentical(from.IndexToWorld, to.IndexToWorld);
}

const PointShell* ShellOf(const BakedVolume& baked) noexcept
{
  const ShapedTool* const tool = ShapedTool::Find(baked);
  return tool ? tool->Description.Points.get() : nullptr;
}

/** Returns the settings of a model, whose tool must have a shape. */
const ShellSettings& TouchOf(const HapticModel& model) noexcept
{
  return static_cast<const ShapedTool&>(*model.Baked->Tool).Description.Touch;
}

/** Maps from the frame of one model's device to that of another model's device. */
class Carrier
{
public:
  Carrier(const HapticModel& from, const HapticModel& to) noexcept
    : From(from)
    , To(to)
    , Rotation(Transpose(to.DeviceToWorldRotation) * from.DeviceToWorldRotation)
    , Turn(ToQuaternion(this->Rotation))
    , Scale(from.WorldUnitsPerMeter / to.WorldUnitsPerMeter)
  {
  }

  ShellPose Carry(const ShellPose& pose) const noexcept
  {
    const Quaternion turned = this->Turn * pose.Orientation;
    return { this->To.WorldToDevice(this->From.DeviceToWorld(pose.Position)),
      (1.0 / std::sqrt(SquaredNorm(turned))) * turned };
  }

  /**
   * Scales the lengths of a contact, and adapts its stiffness and strength per area.
   */
  void Carry(ShellContact& contact) const noexcept
  {
    const double square = this->Scale * this->Scale;
    contact.Offset = this->Scale * (this->Rotation * contact.Offset);
    contact.Depth *= this->Scale;
    contact.Stretch *= this->Scale;
    contact.Energy *= square;
    contact.Stiffness /= square;
    contact.Strength /= square;
  }

  double GetScale() const noexcept { return this->Scale; }

private:
  const HapticModel& From;
  const HapticModel& To;
  const Matrix3 Rotation;
  const Quaternion Turn;
  const double Scale;
};

/** Moves the tool towards the hand until the springs have only this fraction of their energy. */
void Relax(ShellState& state, double fraction) noexcept
{
  const double nearer = std::sqrt(fraction);
  const ShellPose& hand = state.Hand;
  state.Tool.Position = hand.Position + nearer * (state.Tool.Position - hand.Position);
  // The energy of the rotation is proportional to sin^2(theta/2).
  const Quaternion turn = state.Tool.Orientation * Conjugate(hand.Orientation);
  const Vector3 axis = nearer * Vector3{ turn.X, turn.Y, turn.Z };
  const double cosine = std::copysign(std::sqrt(std::max(1.0 - Dot(axis, axis), 0.0)), turn.W);
  const Quaternion turned = Quaternion{ cosine, axis.X, axis.Y, axis.Z } * hand.Orientation;
  state.Tool.Orientation = (1.0 / std::sqrt(SquaredNorm(turned))) * turned;
}

/**
 * Moves the tool and its contacts to another material, other settings, or another placement of the
 * device. The contacts stay on the volume: if the volume moves under the hand, the tool moves with
 * it, and each contact keeps at most its energy. If the springs become stiffer, the tool starts
 * nearer to the hand, so that they have no more energy than before. With another shell or another
 * volume, the state is disabled: the tool starts in the hand, without a force.
 */
void CarryShell(
  const HapticModel& from, const HapticModel& to, ShellState& state, ShellMemory* memory) noexcept
{
  const PointShell* const shell = ShellOf(*to.Baked);
  const bool isSame = state.Enabled && memory && memory->Model == from.Baked->Number && shell &&
    shell == ShellOf(*from.Baked) && IsSameVolume(*from.Baked, *to.Baked);
  if (!isSame)
  {
    state = ShellState{};
    return;
  }
  memory->Model = to.Baked->Number;
  memory->Clearance.Reset();
  state.IsCarried = true;
  const auto energyOf = [&state](const HapticModel& model)
  { return ComputeCouplingEnergy(TouchOf(model), model.Caps, state.Tool, state.Hand); };
  double room = std::max(state.Budget - energyOf(from), 0.0);
  if (!IsIdentical(from.DeviceToWorld, to.DeviceToWorld))
  {
    const Carrier carrier(from, to);
    state.Tool = carrier.Carry(state.Tool);
    state.Hand = carrier.Carry(state.Hand);
    ShellContacts& contacts = memory->GetCurrent();
    for (std::size_t i = 0; i < contacts.Count; ++i)
    {
      carrier.Carry(contacts.List[i]);
    }
    room *= carrier.GetScale() * carrier.GetScale();
  }
  const double before = energyOf(from);
  const double after = energyOf(to);
  if (after > before)
  {
    // The springs are stiffer, but must not contain more energy.
    Relax(state, before / after);
  }
  state.Budget = energyOf(to) + room;
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
  // Never destroyed, because a filter may exist until the process ends.
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
