// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/CarriedProxy.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int MostCarrySteps = 3;
/** Voxels. */
constexpr double LongestCarry = 0.25;
/**
 * After a step s as short as this (voxels), Newton's method has converged: what is left is
 * s^2 / (2 sigma), of an edge of width sigma. A level that holds the proxy is the same in all
 * ticks, so that the next one corrects that; where none holds it, what is left adds up.
 */
constexpr double ShortCarry = 0.01;
constexpr double ShortCarryToLevel = 0.06;

/**
 * Levels and gradients whose relative difference is less than this are the same material's:
 * displacements in single precision are no more precise.
 */
constexpr double SameMaterial = 1e-6;

/** The volume at the proxy before the motion and after it. */
struct Change
{
  FieldSample Now;
  double LevelBefore;
  double LevelNow;
  bool IsNone;
};

/** PRECISE holds its proxy on levels of the estimator's own value, PAPER reads V. */
bool HasOwnLevels(const HapticModel& model) noexcept
{
  return model.Baked->Settings.Solver == HapticSolver::Precise;
}

/** Whether a sample is that of the same material after a motion, but for rounding. */
bool IsSame(const FieldSample& a, const FieldSample& b, double levelA, double levelB) noexcept
{
  const double slope = std::abs(a.Gradient.X) + std::abs(a.Gradient.Y) + std::abs(a.Gradient.Z);
  const Vector3 turned = b.Gradient - a.Gradient;
  return Norm(turned) <= SameMaterial * slope &&
    std::abs(levelB - levelA) <= SameMaterial * (slope + std::abs(levelA));
}

/** @param index of the proxy, before and after it went along with the material */
Change FindChange(const HapticModel& model, const ServoState& state, const Vector3& from,
  const Vector3& index, TickMemory* memory) noexcept
{
  const BakedVolume& baked = *model.Baked;
  const FieldAtTime before = baked.At(state.CarriedTo, memory);
  const FieldAtTime now = baked.At(state.DataTime, memory);
  FieldSample old;
  Change change;
  const bool isShifted = !IsIdentical(from, index);
  const bool isOwn = HasOwnLevels(model);
  if (now.HasFramesOf(before) && !isShifted)
  {
    // Each frame is read once.
    const FramePair<FieldSample> pair = now.ReadFrames(index);
    change.Now = now.Blend(pair);
    old = before.Blend(pair);
    if (!isOwn)
    {
      const FramePair<double> values = now.ReadValues(index, pair);
      change.LevelBefore = before.Blend(values);
      change.LevelNow = now.Blend(values);
    }
  }
  else
  {
    change.Now = now.Gradient(index);
    old = before.Gradient(from);
    if (!isOwn)
    {
      change.LevelBefore = before.Value(from, old);
      change.LevelNow = now.Value(index, change.Now);
    }
  }
  if (isOwn)
  {
    change.LevelBefore = old.Value;
    change.LevelNow = change.Now.Value;
  }
  change.IsNone = isShifted
    ? IsSame(old, change.Now, change.LevelBefore, change.LevelNow)
    : change.LevelBefore == change.LevelNow && IsIdentical(old.Gradient, change.Now.Gradient);
  return change;
}

/** J, that a motion of the proxy adds to the spring. */
double FindWork(const ServoState& state, const Vector3& start) noexcept
{
  const Vector3 motion = state.Proxy - start;
  const Vector3 lag = state.PreviousTip - start;
  return 0.5 * state.Stiffness * (Dot(motion, motion) - 2.0 * Dot(lag, motion));
}

/** Whether a surface of the scalars holds the proxy or could, as far as the last tick tells. */
bool IsSurfaceThere(const ServoState& state, const Surface& surface) noexcept
{
  return surface.Fade > 0.0 && !surface.IsWall && state.SurfaceStrength > 0.0 &&
    state.Stiffness > HapticModel::MinimumStiffness;
}

/** The step (m) of Newton's method along the gradient; not inward past the tip. */
double FindCarry(const HapticModel& model, const Surface& surface, double rise, const Vector3& lag,
  bool isHeld) noexcept
{
  const double slope = surface.GradientMagnitude * model.WorldUnitsPerMeter;
  const double longest = LongestCarry / model.MostVoxelsPerMeter;
  const double wanted = rise / slope;
  const double step = std::isnan(wanted) ? 0.0 : std::clamp(wanted, -longest, longest);
  const bool isTwoSided = model.Baked->Settings.Side == SurfaceSide::Both;
  if (isTwoSided && !isHeld)
  {
    return step; // the side that comes is the structure
  }
  const double push = Dot(lag, surface.Normal);
  return Law::IsDescending(model, lag, surface.Normal) ? std::max(step, std::min(push, 0.0))
                                                       : std::min(step, std::max(push, 0.0));
}

} // namespace

CarriedProxy CarryProxy(const HapticModel& model, ServoState& state, TickMemory* memory) noexcept
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
    index = model.Baked->FollowMaterial(from, state.CarriedTo, state.DataTime);
  }
  if (!IsIdentical(index, from))
  {
    carried.Shift = Inverse(model.DeviceToIndex.Linear) * (index - from);
    state.Proxy += carried.Shift;
    state.Precise.ReachedTip += carried.Shift;
    carried.Work = FindWork(state, start);
  }
  const Change change = FindChange(model, state, from, index, memory);
  if (change.IsNone)
  {
    return carried;
  }
  carried.IsChanged = true;
  const FieldAtTime field = model.Baked->At(state.DataTime, memory);
  carried.There = model.Baked->HasOtherSurfaces
    ? Law::FindSurface(model, field, index, state.Labels)
    : Law::MakeFieldSurface(model, index, change.Now);
  const bool isHeld = state.Precise.IsHeld && HasOwnLevels(model);
  const double target = isHeld ? state.Precise.Level : change.LevelBefore;
  double level = change.LevelNow;
  for (int i = 0; i < MostCarrySteps && IsSurfaceThere(state, carried.There); ++i)
  {
    const Vector3 lag = state.PreviousTip - state.Proxy;
    const double step = FindCarry(model, carried.There, target - level, lag, isHeld);
    state.Proxy += step * carried.There.Normal;
    carried.There.Value += step * carried.There.GradientMagnitude * model.WorldUnitsPerMeter;
    if (std::abs(step) * model.MostVoxelsPerMeter <= (isHeld ? ShortCarryToLevel : ShortCarry))
    {
      break;
    }
    index = model.DeviceToIndex(state.Proxy);
    const FieldSample sample = field.Gradient(index);
    level = HasOwnLevels(model) ? sample.Value : field.Value(index, sample);
    carried.There = Law::MakeFieldSurface(model, index, sample);
  }
  const Vector3 motion = state.Proxy - start - carried.Shift;
  carried.Voxels = Norm(model.DeviceToIndex.Linear * motion);
  carried.Work = FindWork(state, start);
  return carried;
}

} // namespace VolumeHaptics
