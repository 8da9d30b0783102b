// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/ShellCarry.h"

#include "Core/Tools/PointShell/BakedShell.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

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

/** Returns the settings of a model. Its tool must have a shape. */
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
   * Scales the lengths of a contact, and adapts stiffness and strength per area to the new lengths.
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

/** Moves the tool towards the hand until the springs have this fraction of their energy. */
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

} // namespace

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
    // The springs are stiffer, but must not have more energy.
    Relax(state, before / after);
  }
  state.Budget = energyOf(to) + room;
}

} // namespace VolumeHaptics
