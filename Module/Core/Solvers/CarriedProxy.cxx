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
 * After a step s as short as this (voxels), the level is reached: what is left is s^2 / (2 sigma)
 * at most, of an edge of width sigma. A level that holds the proxy is the same in all ticks, so
 * that the next one corrects that; where none holds it, what is left adds up.
 */
constexpr double ShortCarry = 0.01;
constexpr double ShortCarryToLevel = 0.06;
/**
 * After a carry of up to so many voxels, the surface is not read again: its normal and gradient
 * hardly change within it.
 */
constexpr double SameSurface = 0.06;

/**
 * Levels and gradients whose relative difference is less than this are the same material's:
 * displacements in single precision are no more precise.
 */
constexpr double SameMaterial = 1e-6;

/** The volume at the proxy before the motion and after it. */
struct Change
{
  FieldSample Now;
  double LevelBefore = 0.0;
  double LevelNow = 0.0;
  bool IsNone = false;
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

/** @param from, index of the proxy, before and after it went along with the material */
Change FindChange(const HapticModel& model, const FieldAtTime& before, const FieldAtTime& now,
  const Vector3& from, const Vector3& index) noexcept
{
  const bool isShifted = !IsIdentical(from, index);
  Change change;
  FieldSample old;
  if (HasOwnLevels(model))
  {
    old = before.Gradient(from); // first: it is of the older of both blends
    change.Now = now.Gradient(index);
    change.LevelBefore = old.Value;
    change.LevelNow = change.Now.Value;
  }
  else
  {
    change.Now = now.Gradient(index);
    const SharePair levels = isShifted ? SharePair{ before.Value(from), now.Value(index) }
                                       : FieldAtTime::Values(before, now, index);
    change.LevelBefore = levels.First;
    change.LevelNow = levels.Second;
    if (!isShifted && change.LevelBefore != change.LevelNow)
    {
      return change; // whatever the gradient was
    }
    old = before.Gradient(from);
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

/**
 * The step (m) along the gradient by which the level rises by `rise`, if it does so by `slope` per
 * metre; not inward past the tip.
 */
double FindCarry(const HapticModel& model, const Surface& surface, double rise, double slope,
  const Vector3& lag, bool isHeld) noexcept
{
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

/** The surface through an index at which the estimator reads this sample. */
Surface FindThere(const HapticModel& model, ServoState& state, const FieldAtTime& now,
  const Vector3& index, const FieldSample& sample) noexcept
{
  return model.Baked->HasOtherSurfaces ? Law::FindSurface(model, now, index, state.Labels)
                                       : Law::MakeFieldSurface(model, index, sample);
}

/** How much the estimator's level rises per metre along the gradient. */
double FindSlope(const HapticModel& model, const Surface& surface) noexcept
{
  return surface.GradientMagnitude * model.WorldUnitsPerMeter;
}

/**
 * The slope of V, from its rise over the last step; the estimator's if that is more than four times
 * off, as where V is flat.
 */
double FindSlopeOfValue(double estimated, double rise, double step) noexcept
{
  constexpr double most = 4.0;
  const double secant = rise / step;
  return secant > estimated / most && secant < most * estimated ? secant : estimated;
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
    index = model.Baked->FollowMaterial(from, state.CarriedTo, state.DataTime);
  }
  if (!IsIdentical(index, from))
  {
    carried.Shift = Inverse(model.DeviceToIndex.Linear) * (index - from);
    state.Proxy += carried.Shift;
    state.Precise.ReachedTip += carried.Shift;
    carried.Work = FindWork(state, start);
  }
  const FieldAtTime before = model.Baked->At(state.CarriedTo, memory);
  const Change change = FindChange(model, before, now, from, index);
  if (change.IsNone)
  {
    return carried;
  }
  Surface& there = carried.There.emplace(FindThere(model, state, now, index, change.Now));
  const bool isOwn = HasOwnLevels(model);
  const bool isHeld = state.Precise.IsHeld && isOwn;
  const double target = isHeld ? state.Precise.Level : change.LevelBefore;
  double level = change.LevelNow;
  double slope = FindSlope(model, there);
  double away = 0.0; // from where the surface was found, m
  for (int i = 0; i < MostCarrySteps && IsSurfaceThere(state, there); ++i)
  {
    const Vector3 lag = state.PreviousTip - state.Proxy;
    const double step = FindCarry(model, there, target - level, slope, lag, isHeld);
    state.Proxy += step * there.Normal;
    away += step;
    there.Value += step * FindSlope(model, there);
    if (std::abs(step) * model.MostVoxelsPerMeter <= (isHeld ? ShortCarryToLevel : ShortCarry))
    {
      break;
    }
    index = model.DeviceToIndex(state.Proxy);
    if (isOwn)
    {
      const FieldSample sample = now.Gradient(index);
      level = sample.Value;
      there = FindThere(model, state, now, index, sample);
      slope = FindSlope(model, there);
      away = 0.0;
    }
    else if (i + 1 < MostCarrySteps)
    {
      const double reached = now.Value(index);
      slope = FindSlopeOfValue(FindSlope(model, there), reached - level, step);
      level = reached;
    }
  }
  if (std::abs(away) * model.MostVoxelsPerMeter > SameSurface)
  {
    index = model.DeviceToIndex(state.Proxy);
    there = FindThere(model, state, now, index, now.Gradient(index));
  }
  carried.Motion = state.Proxy - start - carried.Shift;
  carried.Work = FindWork(state, start);
  return carried;
}

} // namespace VolumeHaptics
