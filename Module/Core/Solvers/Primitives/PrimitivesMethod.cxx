// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitivesMethod.h"

#include "Core/Law/MaterialLaw.h"

namespace VolumeHaptics
{

void StepPrimitives(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept
{
  const HapticSettings& settings = model.Baked->Settings;
  if (!state.Enabled)
  {
    state.Proxy = record.Tip;
    state.Primitives = {};
  }
  const double k = Law::Capped(settings.CouplingStiffness, model.Caps.Stiffness);
  static_cast<MaterialPoint&>(record) = MaterialPoint{};
  record.Normal = model.FallbackNormal;
  record.Proxy = record.Tip;
  if (!(k > HapticModel::MinimumStiffness))
  {
    state.Primitives = {};
    return;
  }
  record.Stiffness = k;
  const ModeField modes(model, k, record.Tip, state.Labels);
  constexpr double step = 0.25; // in voxels
  const PrimitiveMotion motion = SolvePrimitives(modes.GetField(), k,
    step / model.MostVoxelsPerMeter, state.Proxy, record.Tip, state.Primitives);
  record.Proxy = motion.Proxy;
  record.Force = motion.Force;
  record.IsUnfinished = motion.IsUnfinished;
  record.NormalForce = Norm(motion.Force);
  if (record.NormalForce > Law::ForceEpsilon)
  {
    record.Normal = (-1.0 / record.NormalForce) * motion.Force;
    record.Contact = motion.Steps > 0 ? ContactState::Sliding : ContactState::Sticking;
  }
}

ModeForces ComputeModeForces(const HapticModel& model, const ServoState& state) noexcept
{
  ModeForces forces{};
  if (model.Baked->Settings.Method == HapticMethod::Primitives)
  {
    LabelMemory unused;
    const ModeField modes(model, 0.0, {}, unused);
    for (int i = 0; i < modes.GetCount(); ++i)
    {
      forces[static_cast<std::size_t>(i)] = modes.ForceOf(i, state.Primitives.Forces);
    }
  }
  return forces;
}

Vector3 FindPrimitivesReach(const HapticModel& model) noexcept
{
  // Derivatives are computed over a step of one voxel.
  const Vector3 around = GetKernelReach(model) + Vector3{ 1.0, 1.0, 1.0 };
  return FindValueReach(model, model.KernelLength, around) + Vector3{ ModeWay, ModeWay, ModeWay };
}

} // namespace VolumeHaptics
