// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/CarriedProxy.h"

#include "Core/Solvers/ProxyCarry.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Two levels or gradients belong to the same material if their relative difference is at most this.
 * Displacements in single precision are not more precise.
 */
constexpr double SameMaterial = 1e-6;

/** The volume at the proxy, before and after its motion. */
struct Change
{
  FieldSample Now;
  double LevelBefore = 0.0;
  double LevelNow = 0.0;
  bool IsNone = false;
};

/**
 * Returns whether the levels are the estimator's. The solver Precise holds its proxy on levels of
 * the estimator's own value, whereas Paper reads V.
 */
bool HasOwnLevels(const HapticModel& model) noexcept
{
  return model.Baked->Settings.Solver == HapticSolver::Precise;
}

/**
 * Returns whether two samples, before and after a motion, belong to the same material, apart from
 * rounding.
 */
bool IsSame(const FieldSample& a, const FieldSample& b, double levelA, double levelB) noexcept
{
  const double slope = std::abs(a.Gradient.X) + std::abs(a.Gradient.Y) + std::abs(a.Gradient.Z);
  const Vector3 turned = b.Gradient - a.Gradient;
  return Norm(turned) <= SameMaterial * slope &&
    std::abs(levelB - levelA) <= SameMaterial * (slope + std::abs(levelA));
}

/**
 * Computes the change of the volume at the proxy.
 * @param from, index the proxy's index before and after its motion with the material
 */
Change ComputeChange(const HapticModel& model, const FieldAtTime& before, const FieldAtTime& now,
  const Vector3& from, const Vector3& index) noexcept
{
  const bool isShifted = !IsIdentical(from, index);
  Change change;
  FieldSample old;
  if (HasOwnLevels(model))
  {
    // Read this first, because the gradient belongs to the older of both blends.
    old = before.Gradient(from);
    change.Now = now.Gradient(index);
    change.LevelBefore = old.Value;
    change.LevelNow = change.Now.Value;
  }
  else
  {
    change.Now = now.Gradient(index);
    const FractionPair levels = isShifted ? FractionPair{ before.Value(from), now.Value(index) }
                                          : FieldAtTime::Values(before, now, index);
    change.LevelBefore = levels.First;
    change.LevelNow = levels.Second;
    if (!isShifted && change.LevelBefore != change.LevelNow)
    {
      return change; // the gradient then has no effect on the result
    }
    old = before.Gradient(from);
  }
  change.IsNone = isShifted
    ? IsSame(old, change.Now, change.LevelBefore, change.LevelNow)
    : change.LevelBefore == change.LevelNow && IsIdentical(old.Gradient, change.Now.Gradient);
  return change;
}

/**
 * Returns whether a surface of the scalars holds the proxy, or could hold it, according to the last
 * tick.
 */
bool IsSurfaceThere(const ServoState& state, const Surface& surface) noexcept
{
  return !surface.IsWall && Carrying::IsSurfaceThere(state, surface.Fade);
}

/** Returns the surface through an index, given the estimator's sample there. */
Surface ComputeThere(const HapticModel& model, ServoState& state, const FieldAtTime& now,
  const Vector3& index, const FieldSample& sample) noexcept
{
  return model.Baked->HasOtherSurfaces ? Law::ComputeSurface(model, now, index, state.Labels)
                                       : Law::MakeFieldSurface(model, index, sample);
}

/**
 * Moves state.Proxy to a level of the estimator, and reads the surface again after each step.
 * Returns the distance (m) from the place where the surface was read.
 */
double CarryToOwnLevel(const HapticModel& model, ServoState& state, const FieldAtTime& now,
  const Change& change, Surface& there) noexcept
{
  const bool isHeld = state.Precise.IsHeld;
  const double target = isHeld ? state.Precise.Level : change.LevelBefore;
  double level = change.LevelNow;
  double away = 0.0;
  for (int i = 0; i < Carrying::MostSteps && IsSurfaceThere(state, there); ++i)
  {
    const Vector3 lag = state.PreviousTip - state.Proxy;
    const double slope = Carrying::ComputeSlope(model, there.GradientMagnitude);
    const double step =
      Carrying::ComputeStep(model, there.Normal, target - level, slope, lag, isHeld);
    state.Proxy += step * there.Normal;
    away = step;
    there.Value += step * slope;
    if (std::abs(step) * model.MostVoxelsPerMeter <=
      (isHeld ? Carrying::ShortStepToLevel : Carrying::ShortStep))
    {
      break;
    }
    const Vector3 index = model.DeviceToIndex(state.Proxy);
    const FieldSample sample = now.Gradient(index);
    level = sample.Value;
    there = ComputeThere(model, state, now, index, sample);
    away = 0.0;
  }
  return away;
}

} // namespace

CarriedProxy CarryProxy(
  const HapticModel& model, ServoState& state, const FieldAtTime& now, TickMemory* memory) noexcept
{
  CarriedProxy carried;
  Vector3 index = model.DeviceToIndex(state.Proxy);
  if (state.CarriedTo == state.DataTime || !model.Baked->Field.IsInside(index))
  {
    return carried;
  }
  const Vector3 from = index;
  const Vector3 start = state.Proxy;
  if (!model.Baked->FeelsLabels())
  {
    index = model.Baked->TrackMaterial(from, state.CarriedTo, state.DataTime);
  }
  if (!IsIdentical(index, from))
  {
    carried.Shift = Inverse(model.DeviceToIndex.Linear) * (index - from);
    state.Proxy += carried.Shift;
    state.Precise.ReachedTip += carried.Shift;
    carried.Work = Carrying::ComputeWork(state, start, state.Proxy);
  }
  const FieldAtTime before = model.Baked->At(state.CarriedTo, memory);
  const Change change = ComputeChange(model, before, now, from, index);
  if (change.IsNone)
  {
    return carried;
  }
  Surface& there = carried.There.emplace(ComputeThere(model, state, now, index, change.Now));
  double away = 0.0;
  if (HasOwnLevels(model))
  {
    away = CarryToOwnLevel(model, state, now, change, there);
  }
  else if (IsSurfaceThere(state, there))
  {
    const ProxyCarry carry = Carrying::SolveLevel(model, state, there.Normal,
      there.GradientMagnitude, { change.LevelBefore, change.LevelNow },
      [&now](const Vector3& at) { return now.Value(at); });
    state.Proxy = carry.Proxy;
    away = carry.Away;
  }
  if (!Carrying::IsSameSurface(model, away))
  {
    index = model.DeviceToIndex(state.Proxy);
    there = ComputeThere(model, state, now, index, now.Gradient(index));
  }
  carried.Motion = state.Proxy - start - carried.Shift;
  carried.Work = Carrying::ComputeWork(state, start, state.Proxy);
  return carried;
}

} // namespace VolumeHaptics
