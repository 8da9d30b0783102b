// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Paper/PaperSolver.h"

#include "Core/Solvers/CarriedProxy.h"
#include "Core/Solvers/MaterialLaw.h"
#include "Core/Solvers/ServoState.h"

namespace VolumeHaptics
{
namespace
{

Vector3 Advance(
  const HapticModel& model, const Vector3& start, const SplitLag& lag, TickRecord& record) noexcept
{
  const double k = record.Stiffness;
  if (!Law::IsFelt(record))
  {
    return record.Tip;
  }
  const double threshold = lag.Push > 0.0 ? record.SurfaceStrength : 0.0;
  if (threshold == 0.0 && record.Viscosity == 0.0)
  {
    // Nothing holds the proxy: the law would move it to the tip, up to rounding.
    return record.Tip;
  }
  const Balance balance = Law::Weigh(record, k, lag);
  const Vector3 proxy = Law::StopAtCut(model, start, Law::Move(record, k, lag, balance, start));
  record.NormalForce = balance.Normal;
  record.FrictionForce = balance.Friction;
  record.DragForce = std::min(record.Viscosity, balance.Excess);
  record.Force = k * (proxy - record.Tip);
  if (lag.Push > 0.0 && balance.Normal > Law::ForceEpsilon)
  {
    record.Contact = balance.IsThrough
      ? ContactState::Penetrating
      : (balance.Slides ? ContactState::Sliding : ContactState::Sticking);
  }
  return proxy;
}

/** A tick from the proxy on; the surface through it is null if it has to be found. */
void Step(const HapticModel& model, ServoState& state, TickRecord& record, const FieldAtTime& field,
  const Surface* found) noexcept
{
  const Vector3& tip = record.Tip;
  const Vector3 position = state.Enabled ? state.Proxy : tip;
  const Vector3 lag = tip - position;
  const Vector3 index = model.DeviceToIndex(position);
  Surface surface = found ? *found : Law::FindSurface(model, field, index, state.Labels);
  Law::Orient(model, lag, surface);
  // Before the materials, so that the processor has it by the time they are there.
  const SplitLag split = Law::Split(lag, surface.Normal);
  Law::ReadMaterials(model, field, index, surface, state.Labels, record);
  record.Proxy = state.Enabled ? Advance(model, position, split, record) : tip;
}

} // namespace

void StepPaper(
  const HapticModel& model, ServoState& state, TickRecord& record, TickMemory* memory) noexcept
{
  const FieldAtTime field = model.Baked->At(state.DataTime, memory);
  // A CarriedProxy is large: only where the volume moves, a tick makes one.
  if (!model.Baked->IsMoving() || !state.Enabled)
  {
    Step(model, state, record, field, nullptr);
    return;
  }
  const CarriedProxy carried = CarryProxy(model, state, field, memory);
  record.WallWork = carried.Work;
  Step(model, state, record, field, carried.There ? &*carried.There : nullptr);
}

} // namespace VolumeHaptics
