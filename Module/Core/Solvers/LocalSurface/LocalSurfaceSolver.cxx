// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/LocalSurface/LocalSurfaceSolver.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/State/ServoState.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Smallest slope of a surface (relative to its centre) on which the proxy can move. */
constexpr double LeastSlope = 0.1;
/**
 * The proxy has arrived at the surface if its distance is below this fraction of the depth. The
 * second number is the relative tolerance of the friction.
 */
constexpr double Arrived = 1e-9;
constexpr double CloseToCone = 1e-9;
/**
 * Half of the distance (voxels) over which the slope of V is measured, and the longest motion
 * (voxels) of a surface in a tick.
 */
constexpr double CarryStep = 0.25;
constexpr double LongestFollow = 1.0;
constexpr int MostSteps = 12;
constexpr int MostReturns = 6;
constexpr int MostSlips = 16;
/**
 * Limits of a step: the largest angle (rad) by which it turns the normal, and the least stiffness,
 * which limits the step to 4 Newton steps.
 */
constexpr double MostTurn = 0.5;
constexpr double LeastStiffening = 0.25;
/** A larger change of the lag, as a multiple of the tip's motion, is a jump. */
constexpr double MostFollowing = 2.0;
/** Because of rounding, a period counts as complete from this fraction on. */
constexpr double AlmostOne = 1.0 - 1e-9;

/** Moves a point back to the surface along the slope. Returns false if this is not possible. */
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

/**
 * Moves a point on the surface to the surface point nearest to the tip, by Newton's method. Returns
 * false on failure.
 */
bool Approach(const Quadric& shape, const Vector3& tip, Vector3& x) noexcept
{
  for (int i = 0; i < MostSteps; ++i)
  {
    const Vector3 slope = shape.Slope(x);
    const double norm = Norm(slope);
    const Vector3 lag = tip - x;
    const double depth = Dot(lag, slope) / norm;
    const Vector3 displacement = lag - (depth / norm) * slope;
    const double length = Norm(displacement);
    if (length <= Arrived * std::abs(depth))
    {
      return true;
    }
    const double bend =
      Dot(displacement, shape.Curvature * displacement) / (length * length * norm);
    const double step = 1.0 / std::max(LeastStiffening, 1.0 + bend * depth);
    const double turn = std::abs(bend) * step * length;
    x += (turn > MostTurn ? step * (MostTurn / turn) : step) * displacement;
    if (!Return(shape, x))
    {
      return false;
    }
  }
  return true;
}

/** Returns the point at which the tip passed through the surface. */
Vector3 ComputeEntry(const Quadric& shape, const Vector3& from, const Vector3& tip) noexcept
{
  const double before = shape.Depth(from);
  const double now = shape.Depth(tip);
  return before < 0.0 && now > 0.0 ? from + (before / (before - now)) * (tip - from) : tip;
}

/**
 * Returns how far (world units) the tangential lag of a proxy on the surface exceeds friction.
 */
double Slip(const Quadric& shape, const Vector3& tip, const Vector3& x, double friction) noexcept
{
  const Vector3 slope = shape.Slope(x);
  const Vector3 normal = (1.0 / Norm(slope)) * slope;
  const Vector3 lag = tip - x;
  const double along = Dot(lag, normal);
  return Norm(lag - along * normal) - friction * std::max(0.0, along);
}

/**
 * Moves the proxy on the surface, ignoring cuts. Returns false if the surface does not hold it.
 */
bool HoldWhole(
  const Vector3& tip, double friction, LocalState& local, ContactState& contact) noexcept
{
  const Quadric& shape = local.Surface.Shape;
  if (!local.Surface.IsThere || !(shape.Depth(tip) > 0.0))
  {
    return false;
  }
  Vector3 stuck = local.IsHeld ? local.Position : ComputeEntry(shape, local.Tip, tip);
  if (!Return(shape, stuck))
  {
    return false;
  }
  local.Position = stuck;
  contact = ContactState::Sticking;
  double high = 1.0;
  double atHigh = Slip(shape, tip, stuck, friction);
  if (atHigh <= 0.0)
  {
    return true;
  }
  Vector3 goal = stuck;
  if (!Approach(shape, tip, goal))
  {
    return false;
  }
  local.Position = goal;
  contact = ContactState::Sliding;
  // Move to the point nearest to the goal at which friction still holds (Illinois method). If the
  // search ends early, use the last point at which it does.
  double low = 0.0;
  double atLow = Slip(shape, tip, goal, friction);
  const double near = -CloseToCone * atLow;
  int side = 0;
  for (int i = 0; i < MostSlips && friction > 0.0 && atLow < -near; ++i)
  {
    const double fraction = low + (high - low) * atLow / (atLow - atHigh);
    Vector3 x = goal + fraction * (stuck - goal);
    if (!Return(shape, x))
    {
      break;
    }
    const double at = Slip(shape, tip, x, friction);
    const bool isLow = at <= 0.0;
    const int now = isLow ? -1 : 1;
    (isLow ? atHigh : atLow) *= side == now ? 0.5 : 1.0;
    (isLow ? low : high) = fraction;
    (isLow ? atLow : atHigh) = at;
    local.Position = isLow ? x : local.Position;
    side = now;
  }
  return true;
}

/** Like HoldWhole(), but parts that are cut away have no force. */
bool Hold(const HapticModel& model, const Vector3& tip, double friction, LocalState& local,
  ContactState& contact) noexcept
{
  if (!HoldWhole(tip, friction, local, contact))
  {
    return false;
  }
  if (model.IsCutAway(local.Position))
  {
    contact = ContactState::Free;
    return false;
  }
  return true;
}

/** Spreads a jump of the lag over time. */
void Absorb(const HapticModel& model, const Vector3& jump, LocalState& local) noexcept
{
  const double period = model.Baked->Settings.TickPeriod;
  local.Fading = local.Fading - jump;
  // A new jump must not make an earlier one last longer.
  local.Fall = std::max(
    local.Fall, Norm(local.Fading) * period / std::max(model.Baked->Settings.RecoveryTime, period));
}

Vector3 LagOf(const LocalState& local) noexcept
{
  return local.IsHeld ? local.Position - local.Tip : Vector3{};
}

/**
 * Returns the motion (world) of a surface in a moving volume. The surface's centre moves with the
 * material if displacements are known, and then along the normal to its old level, by a Newton
 * step.
 */
Vector3 ComputeCarry(
  const HapticModel& model, const LocalSurface& surface, double from, double to) noexcept
{
  const BakedVolume& baked = *model.Baked;
  const Affine3 worldToIndex = Inverse(baked.IndexToWorld);
  const Vector3 index = worldToIndex(surface.Shape.Centre);
  if (!baked.Field.IsInside(index))
  {
    return {};
  }
  const Vector3 there = baked.TrackMaterial(index, from, to);
  const FieldAtTime now = baked.At(to);
  const Vector3& normal = surface.Shape.Gradient;
  const Vector3 along = worldToIndex.Linear * normal; // voxels per world unit
  const double voxels = Norm(along);
  const Vector3 step = (CarryStep / voxels) * along;
  const double change = now.Value(there) - baked.At(from).Value(index);
  const ValuePair sides = now.Values(there, step);
  const double carry = -2.0 * CarryStep * change / (sides.Ahead - sides.Behind);
  // This also handles a slope of 0, for which the quotient is not finite.
  const double length =
    std::isfinite(carry) ? std::clamp(carry, -LongestFollow, LongestFollow) : 0.0;
  return baked.IndexToWorld.Linear * (there - index) + (length / voxels) * normal;
}

/**
 * Moves the surface, and the proxy that it holds, with the volume from one data time to another.
 * Returns the distance (world) of this motion, and writes the work (J) on the spring to `work`.
 */
double Carry(const HapticModel& model, double from, double to, double stiffness, LocalState& local,
  double& work) noexcept
{
  if (!model.Baked->IsMoving() || from == to || !local.Surface.IsThere)
  {
    return 0.0;
  }
  const Vector3 motion = ComputeCarry(model, local.Surface, from, to);
  local.Surface.Shape.Centre += motion;
  if (local.IsHeld)
  {
    const Vector3 before = local.Position - local.Tip + local.Fading;
    local.Position += motion;
    const Vector3 now = before + motion;
    const double scale = model.WorldUnitsPerMeter;
    work = 0.5 * stiffness * (Dot(now, now) - Dot(before, before)) / (scale * scale);
  }
  return Norm(motion);
}

/**
 * Updates the tip and moves the proxy along the present surface. `carried` is the distance by which
 * the volume has moved the surface.
 */
void Solve(const HapticModel& model, const Vector3& tip, double carried, double friction,
  LocalState& local, ContactState& contact) noexcept
{
  const double follows = MostFollowing * (Norm(tip - local.Tip) + carried);
  const Vector3 before = LagOf(local);
  local.IsHeld = Hold(model, tip, friction, local, contact);
  local.Tip = tip;
  const Vector3 lag = LagOf(local);
  const Vector3 jump = lag - before;
  const double length = Norm(jump);
  if (length > follows)
  {
    Absorb(model, (1.0 - follows / length) * jump, local);
  }
  const double left = Norm(local.Fading);
  const bool isLeft = left > local.Fall;
  local.Fading = isLeft ? (1.0 - local.Fall / left) * local.Fading : Vector3{};
  local.Fall = isLeft ? local.Fall : 0.0;
  // A hand that moves out before the surface has fully appeared must not be pulled in.
  const double norm = Norm(lag);
  if (norm > 0.0)
  {
    const double inward = -Dot(lag + local.Fading, lag) / norm;
    const double less = std::clamp(inward, 0.0, follows + local.Fall);
    local.Fading += (less / norm) * lag;
  }
}

/** Replaces the surface without changing the felt force. */
void Renew(const HapticModel& model, const LocalSurface& found, double friction, LocalState& local,
  ContactState& contact) noexcept
{
  const Quadric& shape = found.Shape;
  // The far side of a thin structure must not hold the proxy.
  const bool isFar = local.IsHeld && found.IsThere &&
    Dot(local.Surface.Shape.Slope(shape.Centre), shape.Gradient) <= 0.0;
  const Vector3 before = LagOf(local);
  local.Surface = isFar ? LocalSurface{} : found;
  local.IsHeld = Hold(model, local.Tip, friction, local, contact);
  Absorb(model, LagOf(local) - before, local);
}

void WriteForces(const HapticModel& model, const Vector3& felt, const LocalState& local,
  TickRecord& record) noexcept
{
  const double scale = model.WorldUnitsPerMeter;
  const double norm = Norm(felt);
  if (norm == 0.0)
  {
    return;
  }
  const double k = record.Stiffness;
  record.Proxy = model.WorldToDevice(local.Tip + felt);
  record.Force = k * (record.Proxy - record.Tip);
  const Vector3 slope = local.IsHeld ? local.Surface.Shape.Slope(local.Position) : -felt;
  const Vector3 normal = (1.0 / Norm(slope)) * slope;
  const double along = -Dot(felt, normal);
  record.Normal = Transpose(model.DeviceToWorldRotation) * normal;
  record.NormalForce = k * std::abs(along) / scale;
  record.FrictionForce = k * Norm(felt + along * normal) / scale;
}

/** Requests the next surface. */
void Request(const HapticModel& model, const Vector3& motion, LocalState& local) noexcept
{
  const HapticSettings& settings = model.Baked->Settings;
  // The result arrives after one period, and is used for one more period.
  const double ticksAhead = std::max(2.0, 2.0 / (settings.LocalSurfaceRate * settings.TickPeriod));
  const double near = LocalReach * model.WorldUnitsPerMeter / model.MostVoxelsPerMeter;
  local.Request.Position = local.IsHeld ? local.Position : local.Tip;
  local.Request.Ahead = ticksAhead * motion;
  local.Request.Normal = {};
  const Quadric& shape = local.Surface.Shape;
  const Vector3 slope = shape.Slope(local.Request.Position);
  // A proxy near a surface through which it has not passed is outside, even if the value there is
  // inside: behind a plane that touches a hollow, there is a part of the structure.
  if (local.Surface.IsThere && std::abs(shape.Depth(local.Request.Position)) < near)
  {
    local.Request.Normal = (1.0 / Norm(slope)) * slope;
  }
  local.Age = 0;
  ++local.Number;
}

/**
 * Returns how far (world units) around a position the search for a surface reads, without the ray
 * ahead of the tip.
 */
double FindSearchReach(const HapticModel& model) noexcept
{
  return LocalCornerReach * model.Baked->LargestSpacing;
}

} // namespace

void StartLocalSurface(const Vector3& position, const Vector3& tip, LocalState& local) noexcept
{
  // Use a new number, so that the result of an earlier request is ignored.
  const std::uint32_t number = local.Number + 1;
  local = LocalState{};
  local.Number = number;
  local.Tip = tip;
  local.Request.Position = position;
}

void StepLocalSurface(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept
{
  const LocalSurfaceResult& result = input.Result;
  LocalState& local = state.Local;
  const HapticSettings& settings = model.Baked->Settings;
  record.Proxy = record.Tip;
  const bool isFelt = Law::ReadIsoMaterial(model, record);
  const Vector3 tip = model.DeviceToWorld(record.Tip);
  if (!state.Enabled)
  {
    StartLocalSurface(tip, tip, local);
    return;
  }
  const double friction = record.Friction;
  const Vector3 motion = tip - local.Tip;
  const double carried =
    Carry(model, state.CarriedTo, state.DataTime, record.Stiffness, local, record.WallWork);
  record.WallWork = isFelt ? record.WallWork : 0.0;
  Solve(model, tip, carried, friction, local, record.Contact);
  ++local.Age;
  record.IsRenewed = result.IsSimulated
    ? local.Age * settings.TickPeriod * settings.LocalSurfaceRate >= AlmostOne
    : result.Surface != nullptr;
  if (record.IsRenewed)
  {
    LocalSurface found =
      result.IsSimulated ? FitLocalSurface(model, local.Request) : *result.Surface;
    const double from = local.Request.DataTime;
    if (model.Baked->IsMoving() && from != state.DataTime && found.IsThere)
    {
      found.Shape.Centre += ComputeCarry(model, found, from, state.DataTime);
    }
    Renew(model, found, friction, local, record.Contact);
    Request(model, motion, local);
    local.Request.DataTime = state.DataTime;
  }
  record.Contact = local.IsHeld && isFelt ? record.Contact : ContactState::Free;
  if (isFelt)
  {
    WriteForces(model, LagOf(local) + local.Fading, local, record);
  }
}

Vector3 FindLocalSurfaceReach(const HapticModel& model) noexcept
{
  const Vector3 perUnit = (1.0 / model.WorldUnitsPerMeter) * model.VoxelsPerMeter;
  const double bend = model.Baked->Kernel.Radius * model.Baked->LargestSpacing;
  return (FindSearchReach(model) + bend) * perUnit + GetKernelReach(model);
}

void IncludeLocalSurface(const HapticModel& model, const ServoState& state, ReadBox& box) noexcept
{
  const LocalSurfaceRequest& request = state.Local.Request;
  box.Include(model.DeviceToIndex(model.WorldToDevice(request.Position)));
  // The nearest surface to the point ahead may be on any side of it.
  const double most = LocalReachAhead * model.Baked->LargestSpacing;
  const double ahead = std::fmin(Norm(request.Ahead), most) - FindSearchReach(model);
  box.Margin += (std::fmax(ahead, 0.0) / model.WorldUnitsPerMeter) * model.VoxelsPerMeter;
}

} // namespace VolumeHaptics
