// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ServoTick.h"

#include "PreciseSolver.h"
#include "SurfaceProxy.h"

namespace VolumeHaptics
{
namespace
{

/** No hand is farther away (m); squares of what is nearer do not overflow. */
constexpr double FarthestTip = 1e9;

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

/** Eq. 1, at the tip; there is no proxy. */
void StepForceField(
  const HapticModel& model, const Vector3& previousTip, TickRecord& record) noexcept
{
  record.Stiffness = record.Friction = record.Viscosity = record.SurfaceStrength = 0.0;
  const Vector3 push = (-model.Settings.ForceFieldGain * record.GradientMagnitude) * record.Normal;
  const Vector3 velocity = (1.0 / model.Settings.TickPeriod) * (record.Tip - previousTip);
  const double damping = Law::Capped(model.Settings.ForceFieldDamping, model.Settings.Caps.Damping);
  const Vector3 drag = -damping * velocity;
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

void Tick(
  const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record) noexcept
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
  record.IsUnfinished = false;

  const HapticMethod method = model.Settings.Method;
  if (method == HapticMethod::SurfaceProxy && model.Mesh)
  {
    StepSurfaceProxy(model, state, record);
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

std::array<double, ServoStateSize> ToNumbers(const ServoState& state) noexcept
{
  const PreciseState& precise = state.Precise;
  const Vector3& reached = precise.ReachedTip;
  const Spot& here = precise.Here;
  return { state.Proxy.X, state.Proxy.Y, state.Proxy.Z, state.PreviousTip.X, state.PreviousTip.Y,
    state.PreviousTip.Z, state.Enabled ? 1.0 : 0.0, reached.X, reached.Y, reached.Z, precise.Level,
    precise.IsHeld ? 1.0 : 0.0, precise.Spring.Tissue, precise.Spring.Tension,
    precise.Spring.Reserve, here.Normal.X, here.Normal.Y, here.Normal.Z, here.GradientMagnitude,
    here.SurfaceValue, here.MediumValue, here.Stiffness, here.Friction, here.Viscosity,
    here.SurfaceStrength, here.Value, here.Slope, precise.Stray, precise.Gain };
}

ServoState FromNumbers(const std::array<double, ServoStateSize>& n) noexcept
{
  ServoState state;
  state.Proxy = { n[0], n[1], n[2] };
  state.PreviousTip = { n[3], n[4], n[5] };
  state.Enabled = n[6] != 0.0;
  state.Precise.ReachedTip = { n[7], n[8], n[9] };
  state.Precise.Level = n[10];
  state.Precise.IsHeld = n[11] != 0.0;
  state.Precise.Spring = { n[12], n[13], n[14] };
  Spot& here = state.Precise.Here;
  here.Normal = { n[15], n[16], n[17] };
  here.GradientMagnitude = n[18];
  here.SurfaceValue = n[19];
  here.MediumValue = n[20];
  here.Stiffness = n[21];
  here.Friction = n[22];
  here.Viscosity = n[23];
  here.SurfaceStrength = n[24];
  here.Value = n[25];
  here.Slope = n[26];
  state.Precise.Stray = n[27];
  state.Precise.Gain = n[28];
  return state;
}

void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state) noexcept
{
  const auto carry = [&](const Vector3& x) { return to.WorldToDevice(from.DeviceToWorld(x)); };
  state.Proxy = carry(state.Proxy);
  state.Precise.ReachedTip = carry(state.Precise.ReachedTip);
  state.Precise.Spring.DropReserve();
  state.Precise.Stray = PreciseState::Unknown;
  state.Precise.Gain = 1.0;
  const HapticSettings& was = from.Settings;
  if (was.Method != to.Settings.Method || was.Solver != to.Settings.Solver)
  {
    // Only PRECISE keeps its state up to date.
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = carry(state.PreviousTip);
    if (was.Method != to.Settings.Method && to.Settings.Method == HapticMethod::SurfaceProxy)
    {
      state.Proxy = EnterSurface(to, state.Proxy);
    }
  }
  // In another volume the level means nothing.
  state.Precise.IsHeld = state.Precise.IsHeld && &from.Field == &to.Field;
}

} // namespace VolumeHaptics
