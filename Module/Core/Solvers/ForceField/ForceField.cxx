// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/ForceField/ForceField.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{

Vector3 ComputeFieldPush(const HapticModel& model, const TickRecord& record) noexcept
{
  const double fraction = model.Baked->KeptFraction(model.DeviceToIndex(record.Tip));
  return (-model.Baked->Settings.ForceFieldGain * record.GradientMagnitude * fraction) *
    record.Normal;
}

Vector3 ComputeFieldDamping(
  const HapticModel& model, const Vector3& from, const TickRecord& record) noexcept
{
  const Vector3 velocity = (1.0 / model.Baked->Settings.TickPeriod) * (record.Tip - from);
  const double damping = Law::Capped(model.Baked->Settings.ForceFieldDamping, model.Caps.Damping);
  return -damping * velocity;
}

Vector3 ComputeFieldPlace(const HapticModel& model, const ServoState& state) noexcept
{
  const Vector3 index = model.DeviceToIndex(state.PreviousTip);
  if (!model.Baked->IsMoving() || model.Baked->FeelsLabels() || state.CarriedTo == state.DataTime ||
    !model.Baked->Field.IsInside(index))
  {
    return state.PreviousTip;
  }
  const Vector3 now = model.Baked->TrackMaterial(index, state.CarriedTo, state.DataTime);
  return state.PreviousTip + Inverse(model.DeviceToIndex.Linear) * (now - index);
}

void StepForceField(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept
{
  const FieldAtTime field = model.Baked->At(state.DataTime, input.Memory);
  const Vector3 index = model.DeviceToIndex(record.Tip);
  const Surface surface = Law::ComputeFieldSurface(model, field, index);
  Law::ReadMaterials(model, field, index, surface, state.Labels, record);
  record.Proxy = record.Tip;
  if (!state.Enabled)
  {
    return;
  }
  record.Stiffness = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  const Vector3 push = ComputeFieldPush(model, record);
  const Vector3 place = ComputeFieldPlace(model, state);
  const Vector3 damping = ComputeFieldDamping(model, place, record);
  record.WallWork = Dot(damping, place - state.PreviousTip);
  record.NormalForce = Norm(push);
  record.DragForce = Norm(damping);
  record.Force = push + damping;
}

Vector3 FindFieldReach(const HapticModel& model) noexcept
{
  return FindValueReach(model, model.KernelLength, GetKernelReach(model));
}

Vector3 FindFieldDrag(
  const HapticModel& model, const ServoState& before, const TickRecord& record) noexcept
{
  if (!(record.DragForce > 0.0))
  {
    return {};
  }
  // Only the damping of the hand's own motion removes energy. The damping relative to moving
  // material may add energy.
  const Vector3 drag = ComputeFieldDamping(model, before.PreviousTip, record);
  const Vector3 material = ComputeFieldDamping(model, ComputeFieldPlace(model, before), record);
  const double whole = Norm(ComputeFieldPush(model, record) + material);
  // Reduce the drag by the same factor as the force, which may be clamped.
  return whole > 0.0 ? (Norm(record.Force) / whole) * drag : Vector3{};
}

} // namespace VolumeHaptics
