// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ServoTick.h"

#include "PreciseSolver.h"
#include "SurfaceProxy.h"

namespace VolumeHaptics
{
namespace
{

/** SPEC 2: one place, one look at the law. */
Vector3 StepPaper(const Vector3& start, const SplitLag& lag, TickRecord& record) noexcept
{
  const double k = record.Stiffness;
  if (!Law::IsFelt(record))
  {
    return record.Tip;
  }
  const double threshold = lag.Push > 0.0 ? record.SurfaceStrength : 0.0;
  if (threshold == 0.0 && record.Viscosity == 0.0)
  {
    // Nothing holds the proxy, and the law would bring it to the tip but for rounding.
    return record.Tip;
  }
  const Balance balance = Law::Weigh(record, k, lag);
  const Vector3 proxy = Law::Move(record, k, lag, balance, start);
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

Vector3 FieldPush(const HapticModel& model, const TickRecord& record) noexcept
{
  return (-model.Settings.ForceFieldGain * record.GradientMagnitude) * record.Normal;
}

Vector3 FieldDrag(
  const HapticModel& model, const Vector3& previousTip, const TickRecord& record) noexcept
{
  const Vector3 velocity = (1.0 / model.Settings.TickPeriod) * (record.Tip - previousTip);
  const double damping = Law::Capped(model.Settings.ForceFieldDamping, model.Settings.Caps.Damping);
  return -damping * velocity;
}

/** Eq. 1, at the tip; there is no proxy. */
void StepForceField(
  const HapticModel& model, const Vector3& previousTip, TickRecord& record) noexcept
{
  record.Stiffness = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  const Vector3 push = FieldPush(model, record);
  const Vector3 drag = FieldDrag(model, previousTip, record);
  record.NormalForce = Norm(push);
  record.DragForce = Norm(drag);
  record.Force = push + drag;
}

/** The methods that look at one place a tick. */
void StepOnce(
  const HapticModel& model, bool isField, const ServoState& state, TickRecord& record) noexcept
{
  const Vector3& tip = record.Tip;
  const Vector3 position = state.Enabled && !isField ? state.Proxy : tip;
  const Vector3 lag = tip - position;
  const Vector3 index = model.DeviceToIndex(position);
  Surface surface = Law::FindSurface(model, index);
  if (!isField)
  {
    Law::Orient(model, lag, surface);
  }
  // Before the materials, so that the processor has it by the time they are there.
  const SplitLag split = Law::Split(lag, surface.Normal);
  Law::ReadMaterials(model, index, surface, record);
  record.Proxy = tip;
  if (state.Enabled && isField)
  {
    StepForceField(model, state.PreviousTip, record);
  }
  else if (state.Enabled)
  {
    record.Proxy = StepPaper(position, split, record);
  }
}

} // namespace

void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record,
  const LocalAnswer& answer) noexcept
{
  // Also false for NaN.
  const bool isSomewhere =
    std::abs(tip.X) < FarthestTip && std::abs(tip.Y) < FarthestTip && std::abs(tip.Z) < FarthestTip;
  if (!isSomewhere)
  {
    record = TickRecord{};
    record.Tip = tip;
    record.Proxy = state.Proxy;
    state.Enabled = false;
    return;
  }
  // What the methods below do not always write.
  record.Tip = tip;
  record.Force = Vector3{};
  record.NormalForce = record.FrictionForce = record.DragForce = 0.0;
  record.Contact = ContactState::Free;
  record.IsUnfinished = record.IsRenewed = false;

  const HapticMethod method = model.Settings.Method;
  if (method == HapticMethod::SurfaceProxy && model.Mesh)
  {
    StepSurfaceProxy(model, state, record);
  }
  else if (method == HapticMethod::LocalSurface)
  {
    StepLocalSurface(model, state, record, answer);
  }
  else if (method == HapticMethod::Proxy && model.Settings.Solver == HapticSolver::Precise)
  {
    StepPrecise(model, state, record);
  }
  else
  {
    StepOnce(model, method == HapticMethod::ForceField, state, record);
  }
  state.Proxy = record.Proxy;
  state.PreviousTip = tip;
  state.Enabled = true;

  const double limit = model.Settings.MaximumForce;
  if (limit > 0.0)
  {
    const double norm = Norm(record.Force);
    record.Force = norm > limit ? (limit / norm) * record.Force : record.Force;
  }
}

Vector3 FindDrag(
  const HapticModel& model, const Vector3& previousTip, const TickRecord& record) noexcept
{
  const bool isField = model.Settings.Method == HapticMethod::ForceField;
  if (!isField || !(record.DragForce > 0.0))
  {
    return {};
  }
  const Vector3 drag = FieldDrag(model, previousTip, record);
  const double whole = Norm(FieldPush(model, record) + drag);
  // The force may be clamped.
  return whole > 0.0 ? (Norm(record.Force) / whole) * drag : Vector3{};
}

void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state) noexcept
{
  const bool isRegion = !from.Resident.IsWhole() || !to.Resident.IsWhole();
  if (isRegion && from.BakedNumber == to.BakedNumber &&
    IsIdentical(from.DeviceToWorld, to.DeviceToWorld))
  {
    // Another part of the same: nothing has changed for what is felt.
    return;
  }
  const auto carry = [&](const Vector3& x) { return to.WorldToDevice(from.DeviceToWorld(x)); };
  state.Proxy = carry(state.Proxy);
  state.Precise.ReachedTip = carry(state.Precise.ReachedTip);
  state.Precise.Spring.DropReserve();
  state.Precise.Stray = PreciseState::Unknown;
  state.Precise.Gain = 1.0;
  const HapticSettings& was = from.Settings;
  const bool isOther = was.Method != to.Settings.Method;
  if (isOther || was.Solver != to.Settings.Solver)
  {
    // Methods and solvers keep but their own state up to date.
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = carry(state.PreviousTip);
  }
  if (isOther)
  {
    const Vector3 outside = EnterSurface(to, state.Proxy);
    state.Proxy = to.Settings.Method == HapticMethod::SurfaceProxy ? outside : state.Proxy;
    StartLocalSurface(to.DeviceToWorld(outside), to.DeviceToWorld(state.PreviousTip), state.Local);
  }
  // In another volume the level means nothing.
  state.Precise.IsHeld = state.Precise.IsHeld && from.BakedNumber == to.BakedNumber;
}

} // namespace VolumeHaptics
