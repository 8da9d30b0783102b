// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Paper/PaperSolver.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/Math/KernelInline.h"
#include "Core/Solvers/CarriedProxy.h"
#include "Core/Solvers/ProxyCarry.h"
#include "Core/State/ServoState.h"

#include <optional>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns the proxy's new position according to the law, and writes the forces. The proxy stops at
 * the faces of a cut.
 */
template <bool MayHaveCut>
VOLUME_HAPTICS_INLINE Vector3 Advance(
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
    // No surface holds the proxy. The law would also move it to the tip, but with rounding errors.
    return record.Tip;
  }
  const Balance balance = Law::Weigh(record, k, lag);
  const Vector3 moved = Law::Move(record, k, lag, balance, start);
  const Vector3 proxy = MayHaveCut ? Law::StopAtCut(model, start, moved) : moved;
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

/**
 * Computes a tick that starts with the present proxy. `found` is the surface through the proxy, or
 * null if it is not known.
 */
void Step(const HapticModel& model, ServoState& state, TickRecord& record, const FieldAtTime& field,
  const Surface* found) noexcept
{
  const Vector3& tip = record.Tip;
  const Vector3 position = state.Enabled ? state.Proxy : tip;
  const Vector3 lag = tip - position;
  const Vector3 index = model.DeviceToIndex(position);
  Surface surface = found ? *found : Law::ComputeSurface(model, field, index, state.Labels);
  Law::Orient(model, lag, surface);
  // Compute this before the materials are read, so that the processor can do both at the same time.
  const SplitLag split = Law::Split(lag, surface.Normal);
  Law::ReadMaterials(model, field, index, surface, state.Labels, record);
  record.Proxy = state.Enabled ? Advance<true>(model, position, split, record) : tip;
}

/**
 * Computes the rest of a tick in a plain volume (BakedVolume::IsPlain), given the surface. The
 * result equals that of Step(), to the bit. Uses no Surface and no FieldAtTime, because the
 * processor would have to wait for their members in memory.
 * @param slope slope at the proxy, which this function turns towards the structure
 * @param fade factor of the surface's strength (Surface::Fade)
 */
template <typename Field>
VOLUME_HAPTICS_INLINE void FeelPlain(const HapticModel& model, const Vector3& position,
  const Vector3& index, Law::Slope& slope, double fade, const Field& field,
  TickRecord& record) noexcept
{
  const BakedVolume& baked = *model.Baked;
  const Vector3 lag = record.Tip - position;
  if (Law::IsDescending(model, lag, slope.Normal))
  {
    slope.Normal = -slope.Normal;
    slope.Reach = -slope.Reach;
  }
  const SplitLag split = Law::Split(lag, slope.Normal);
  const DistinctnessTable::Values distinct = baked.Distinctness(slope.Magnitude);
  const ValuePair values = field.Values(index, slope.Reach);
  record.Normal = slope.Normal;
  record.GradientMagnitude = slope.Magnitude;
  Law::JoinMaterials(model, values, baked.Materials(values.Ahead), baked.Materials(values.Behind),
    distinct, fade, 1.0, record);
  record.Proxy = Advance<false>(model, position, split, record);
}

/** Computes a tick in a plain volume that does not move. The state must be enabled. */
void StepPlain(
  const HapticModel& model, ServoState& state, TickRecord& record, TickMemory* memory) noexcept
{
  const FieldSampler& field = model.Baked->Field;
  const Vector3 index = model.DeviceToIndex(state.Proxy);
  Law::Slope slope;
  if (!field.IsInside(index) ||
    !Law::ComputeSlope(model, field.Gradient(index, memory ? &memory->Of(0) : nullptr), slope))
  {
    const Surface none = Law::MakeNoSurface(model);
    Step(model, state, record, FieldAtTime(field, memory), &none);
    return;
  }
  FeelPlain(model, state.Proxy, index, slope, model.BorderFade(index), field, record);
}

/**
 * Computes a tick in a plain volume that moves. The state must be enabled. The result equals that
 * of a tick with CarryProxy(), to the bit. Returns false if CarryProxy() must be used instead.
 */
VOLUME_HAPTICS_OUTLINE bool StepPlainMotion(
  const HapticModel& model, ServoState& state, TickRecord& record, TickMemory& memory) noexcept
{
  std::optional<FieldStep> field =
    model.Baked->ComputeStep(state.CarriedTo, state.DataTime, memory);
  Vector3 index = model.DeviceToIndex(state.Proxy);
  Law::Slope slope;
  if (!field || !field->IsInside(index) || !Law::ComputeSlope(model, field->Gradient(index), slope))
  {
    return false;
  }
  const FractionPair levels = field->Values(index);
  if (levels.First == levels.Second)
  {
    return false; // CarryProxy() checks whether the volume has changed here
  }
  double fade = model.BorderFade(index);
  const Vector3 start = state.Proxy;
  if (Carrying::IsSurfaceThere(state, fade))
  {
    const ProxyCarry carry = Carrying::SolveLevel(model, state, slope.Normal, slope.Magnitude,
      levels, [&field](const Vector3& at) { return field->Value(at); });
    state.Proxy = carry.Proxy;
    index = model.DeviceToIndex(carry.Proxy);
    record.WallWork = Carrying::ComputeWork(state, start, carry.Proxy);
    if (!Carrying::IsSameSurface(model, carry.Away))
    {
      if (!Law::ComputeSlope(model, field->Gradient(index), slope))
      {
        const Surface none = Law::MakeNoSurface(model);
        Step(model, state, record, model.Baked->At(state.DataTime, &memory), &none);
        return true;
      }
      fade = model.BorderFade(index);
    }
  }
  FeelPlain(model, state.Proxy, index, slope, fade, *field, record);
  return true;
}

} // namespace

void StepPaper(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept
{
  TickMemory* const memory = input.Memory;
  const bool isMoving = model.Baked->IsMoving();
  if (state.Enabled && model.Baked->IsPlain())
  {
    if (!isMoving)
    {
      StepPlain(model, state, record, memory);
      return;
    }
    if (memory && state.CarriedTo != state.DataTime &&
      StepPlainMotion(model, state, record, *memory))
    {
      return;
    }
  }
  const FieldAtTime field = model.Baked->At(state.DataTime, memory);
  // A CarriedProxy is large, so make one only if the volume moves.
  if (!isMoving || !state.Enabled)
  {
    Step(model, state, record, field, nullptr);
    return;
  }
  const CarriedProxy carried = CarryProxy(model, state, field, memory);
  record.WallWork = carried.Work;
  Step(model, state, record, field, carried.There ? &*carried.There : nullptr);
}

Vector3 FindPaperReach(const HapticModel& model) noexcept
{
  return FindValueReach(model, FindMaterialReach(model), GetKernelReach(model));
}

} // namespace VolumeHaptics
