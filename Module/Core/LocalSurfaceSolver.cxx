// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalSurfaceSolver.h"

#include "ServoTick.h"

namespace VolumeHaptics
{
namespace
{

/** A blend of surfaces that are this nearly opposite (slope, of 1) has no place to hold a proxy. */
constexpr double LeastSlope = 0.1;
/** Shares of the proxy's depth below which it has arrived. */
constexpr double Arrived = 1e-9;
constexpr int MostSteps = 12;
constexpr int MostReturns = 6;
/** A step turns the normal by no more than this (radian), and by no more than this much of what a plane asks. */
constexpr double MostTurn = 0.5;
constexpr double LeastStiffening = 0.25;
/** Share of a period that is a whole one but for rounding. */
constexpr double AlmostOne = 1.0 - 1e-9;

/** What is felt now. */
Quadric Feel(const HapticModel& model, const LocalState& local) noexcept
{
  const double recovery = model.Settings.RecoveryTime;
  const double time = local.Ticks * model.Settings.TickPeriod;
  return Blend(local.Old, local.New, time < recovery ? time / recovery : 1.0);
}

/** Lets the share of the stiffness grow or fall by a tick. */
void MoveShare(const HapticModel& model, LocalState& local) noexcept
{
  const double recovery = model.Settings.RecoveryTime;
  const double step =
    recovery > model.Settings.TickPeriod ? model.Settings.TickPeriod / recovery : 1.0;
  local.Share =
    local.IsComing ? std::min(1.0, local.Share + step) : std::max(0.0, local.Share - step);
}

/** Takes an answer in. */
void Renew(const Quadric& felt, const LocalSurface& found, LocalState& local) noexcept
{
  const Quadric& shape = found.Shape;
  const bool wasThere = local.Share > 0.0;
  local.Ticks = 0;
  if (found.IsThere && wasThere && Dot(felt.Slope(shape.Centre), shape.Gradient) > 0.0)
  {
    local.Old = felt.Around(shape.Centre);
    local.New = shape;
    local.IsComing = true;
  }
  else if (wasThere && (local.IsHeld || !found.IsThere))
  {
    // Nothing is there any more, or the far side of something thin.
    local.Old = local.New = felt;
    local.IsComing = false;
  }
  else
  {
    local.Old = local.New = shape;
    local.Share = 0.0;
    local.IsComing = found.IsThere;
  }
}

/** Takes a place back to the surface, along its slope; false where there is no way. */
bool Return(const Quadric& shape, Vector3& x) noexcept
{
  for (int i = 0; i < MostReturns; ++i)
  {
    const Vector3 slope = shape.Slope(x);
    const double square = Dot(slope, slope);
    if (square < LeastSlope * LeastSlope)
    {
      return false;
    }
    x = x - (shape.Depth(x) / square) * slope;
  }
  return true;
}

/** From a place on the surface to the one that is nearest to the tip (Newton, on the surface). */
bool Approach(const Quadric& shape, const Vector3& tip, Vector3& x) noexcept
{
  for (int i = 0; i < MostSteps; ++i)
  {
    const Vector3 slope = shape.Slope(x);
    const double norm = Norm(slope);
    const Vector3 lag = tip - x;
    const double depth = Dot(lag, slope) / norm;
    const Vector3 way = lag - (depth / norm) * slope;
    const double length = Norm(way);
    if (length <= Arrived * std::abs(depth))
    {
      return true;
    }
    const double bend = Dot(way, shape.Curvature * way) / (length * length * norm);
    const double step = 1.0 / std::max(LeastStiffening, 1.0 + bend * depth);
    const double turn = std::abs(bend) * step * length;
    x += (turn > MostTurn ? step * (MostTurn / turn) : step) * way;
    if (!Return(shape, x))
    {
      return false;
    }
  }
  return true;
}

/** Where the tip came through the surface. */
Vector3 FindEntry(const Quadric& shape, const Vector3& from, const Vector3& tip) noexcept
{
  const double before = shape.Depth(from);
  const double now = shape.Depth(tip);
  return before < 0.0 && now > 0.0 ? from + (before / (before - now)) * (tip - from) : tip;
}

/** Moves the proxy; false where nothing holds it. */
bool Hold(const HapticModel& model, const ServoState& state, const Quadric& shape,
  const Vector3& tip, TickRecord& record) noexcept
{
  const LocalState& local = state.Local;
  if (!((local.Share > 0.0 || local.IsComing) && shape.Depth(tip) > 0.0))
  {
    return false;
  }
  Vector3 stuck = local.IsHeld ? model.DeviceToWorld(state.Proxy)
                               : FindEntry(shape, model.DeviceToWorld(state.PreviousTip), tip);
  if (!Return(shape, stuck))
  {
    return false;
  }
  Vector3 goal = stuck;
  if (!Approach(shape, tip, goal))
  {
    return false;
  }
  const Vector3 held = tip - goal;
  const double depth = Norm(held);
  const double slack = record.Friction * depth;
  const double way = Norm(stuck - goal);
  const bool isSliding = way > slack;
  Vector3 proxy = isSliding ? goal + (slack / way) * (stuck - goal) : stuck;
  if (isSliding && slack > 0.0 && !Return(shape, proxy))
  {
    return false;
  }
  const double k = record.Stiffness * local.Share;
  const double scale = model.WorldUnitsPerMeter;
  record.Stiffness = k;
  record.Proxy = model.WorldToDevice(proxy);
  record.Force = k * (record.Proxy - record.Tip);
  record.NormalForce = k * depth / scale;
  record.FrictionForce = k * std::min(way, slack) / scale;
  if (record.NormalForce > Law::ForceEpsilon)
  {
    record.Normal = (1.0 / depth) * (Transpose(model.DeviceToWorldRotation) * held);
    record.Contact = isSliding ? ContactState::Sliding : ContactState::Sticking;
  }
  return true;
}

/** Where the next surface is looked for. */
void Ask(const HapticModel& model, const ServoState& state, const TickRecord& record,
  LocalState& local) noexcept
{
  const HapticSettings& settings = model.Settings;
  // The answer comes one period from now, and stays for another.
  const double ticksAhead = 2.0 / (settings.LocalSurfaceRate * settings.TickPeriod);
  const Vector3 motion = record.Tip - state.PreviousTip;
  local.Asked.Where = model.DeviceToWorld(record.Proxy);
  local.Asked.Ahead = ticksAhead * (model.DeviceToWorld.Linear * motion);
  local.Asked.Normal = local.IsHeld ? model.DeviceToWorldRotation * record.Normal : Vector3{};
  local.Age = 0;
  ++local.Number;
}

} // namespace

void StartLocalSurface(const Vector3& where, LocalState& local) noexcept
{
  // An answer to what was asked before is none to this.
  const std::uint32_t number = local.Number + 1;
  local = LocalState{};
  local.Number = number;
  local.Asked.Where = where;
}

void StepLocalSurface(const HapticModel& model, ServoState& state, TickRecord& record,
  const LocalAnswer& answer) noexcept
{
  LocalState& local = state.Local;
  record.Proxy = record.Tip;
  const bool isFelt = Law::ReadIsoMaterial(model, record);
  if (!state.Enabled)
  {
    StartLocalSurface(model.DeviceToWorld(record.Tip), local);
    return;
  }
  const HapticSettings& settings = model.Settings;
  ++local.Age;
  ++local.Ticks;
  MoveShare(model, local);
  Quadric felt = Feel(model, local);
  const bool isDue = answer.IsSimulated
    ? local.Age * settings.TickPeriod * settings.LocalSurfaceRate >= AlmostOne
    : answer.Surface != nullptr;
  if (isDue)
  {
    Renew(felt, answer.IsSimulated ? FitLocalSurface(model, local.Asked) : *answer.Surface, local);
    felt = Feel(model, local);
    record.IsRenewed = true;
  }
  local.IsHeld = isFelt && Hold(model, state, felt, model.DeviceToWorld(record.Tip), record);
  if (isDue)
  {
    Ask(model, state, record, local);
  }
}

} // namespace VolumeHaptics
