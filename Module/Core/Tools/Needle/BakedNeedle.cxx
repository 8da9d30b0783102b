// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Needle/BakedNeedle.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"
#include "Core/Tools/Needle/NeedleTissue.h"
#include "Core/Tools/Needle/NeedleTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/*
 * Rules for the puncture by a free needle. The needle must come from a place where nothing resists.
 * It punctures a surface when the spring pushes with the surface's full strength and the lag then
 * falls. If a surface never gives way, the needle punctures it when it has been pushed in by two
 * kernel lengths.
 */

/** If the needle breaks through a surface, the lag falls by at least this fraction. */
constexpr double BreakFraction = 1e-3;
/**
 * A needle that was pushed in by this length (kernel lengths) punctures a surface even if it still
 * holds.
 */
constexpr double MostPushed = 2.0;
constexpr double SmallestLag = 1e-9; // smallest lag (m)
/** A surface may give way from this fraction of its strength on. */
constexpr double WholeFraction = 0.99;
/** The direction of the hand's motion is averaged over this length (m). */
constexpr double MotionLength = 1e-3;
/**
 * Least cosine of the angle between motion and normal. With a smaller one, the motion is along the
 * surface and does not show the axis.
 */
constexpr double LeastPush = 0.2;
/** A track begins at most this far behind the tip (steps). */
constexpr double MostBack = 64.0;

/** The state of a free needle at the beginning of a tick. */
struct FreeTick
{
  explicit FreeTick(const ServoState& state) noexcept
    : Proxy(state.Proxy)
    , Tip(state.PreviousTip)
    , Stiffness(state.Stiffness)
    , SurfaceStrength(state.SurfaceStrength)
  {
  }

  Vector3 Proxy;
  Vector3 Tip;
  double Stiffness;
  double SurfaceStrength;
};

/** Adds a step to the hand's recent motion (m), in which older motion has less weight. */
void UpdateMotion(const Vector3& step, Vector3& motion) noexcept
{
  const double kept = std::max(0.0, 1.0 - Norm(step) / MotionLength);
  motion = kept * motion + step;
}

Vector3 HeadingOf(const Vector3& v) noexcept
{
  const double length = Norm(v);
  return length > SmallestLag ? (1.0 / length) * v : Vector3{};
}

/**
 * Returns the unit direction of a needle that is being inserted, or 0 if it is not known.
 * @param normal normal of the surface that holds the needle; 0 if none does
 */
Vector3 FindAxis(const ServoState& state, const Vector3& lag, const Vector3& normal) noexcept
{
  if (state.HasOrientation)
  {
    return AxisOfStylus(state.Orientation);
  }
  const Vector3 motion = HeadingOf(state.Needle.Motion);
  const bool isPushed =
    Dot(normal, normal) > 0.0 ? Dot(motion, normal) > LeastPush : Dot(motion, lag) > 0.0;
  return isPushed ? motion : HeadingOf(lag);
}

void Begin(ServoState& state, const Vector3& entry, const Vector3& axis, const Vector3& normal,
  double stiffness) noexcept
{
  state.Needle = NeedleState{};
  state.Needle.IsInserted = true;
  state.Needle.Axis = axis;
  state.Needle.Normal = normal;
  state.Needle.Entry = entry;
  state.Needle.Stiffness = stiffness;
  state.Proxy = entry;
}

/** The surface that holds a free needle in a tick in which it may break through. */
struct HeldAt
{
  Vector3 Normal;        ///< unit vector into the structure; 0 if no surface holds
  double Push = 0.0;     ///< push of the spring against the surface (N)
  NeedleTissue Behind;   ///< tissue of the surface; only read if there is a push
  double Strength = 0.0; ///< T W_d (N)
  bool IsWhole() const noexcept
  {
    // A label behind the surface holds with its full strength, without the distinctness W_d.
    return this->Behind.Puncture > 0.0 && this->Push >= WholeFraction * this->Behind.Puncture;
  }
};

HeldAt ComputeHeld(const HapticModel& model, const NeedleTissueReader& reader,
  const NeedleState& needle, const FreeTick& before, const TickRecord& record) noexcept
{
  HeldAt held;
  // The solver Precise may pass through a surface within a tick, without a normal force at the
  // tick's end.
  held.Normal = record.NormalForce > Law::ForceEpsilon ? record.Normal : needle.Normal;
  held.Push = before.Stiffness * Dot(record.Tip - before.Proxy, held.Normal);
  if (held.Push > 0.0)
  {
    held.Behind = reader.At(before.Proxy + model.KernelLengthAlong(held.Normal) * held.Normal);
  }
  held.Strength = std::max(before.SurfaceStrength, record.SurfaceStrength);
  return held;
}

/**
 * Returns whether a tick of the free needle has broken through the surface that held it. `pushed`
 * is the distance (m) by which the needle was pushed in.
 */
bool IsThrough(const HapticModel& model, const HeldAt& held, const FreeTick& before,
  const Vector3& axis, const TickRecord& record, double& pushed) noexcept
{
  const bool isPressed = held.Push >= WholeFraction * before.SurfaceStrength && held.Push > 0.0;
  if (!(Dot(held.Normal, axis) > 0.0) || !isPressed)
  {
    pushed = 0.0;
    return false;
  }
  pushed += std::max(0.0, Dot(record.Proxy - before.Proxy, axis));
  const double lagBefore = Dot(before.Tip - before.Proxy, axis);
  const double lag = Dot(record.Tip - record.Proxy, axis);
  const bool isForwards = Dot(record.Tip - before.Tip, axis) >= 0.0;
  return held.IsWhole() || (isForwards && lag < (1.0 - BreakFraction) * lagBefore) ||
    pushed > MostPushed * model.KernelLengthAlong(axis);
}

/**
 * Sets the force of a surface at its puncture, in addition to R at the entry. The entry may be
 * behind the boundary, so T and R in front of the surface are used, as for the free needle.
 */
void SetPuncture(const HapticModel& model, const NeedleTissueReader& reader, const HeldAt& held,
  NeedleState& needle) noexcept
{
  if (held.Behind.HasPuncture)
  {
    const Vector3 back = model.KernelLengthAlong(held.Normal) * held.Normal;
    const double front = reader.At(needle.Entry - back).Cutting;
    const double here = reader.At(needle.Entry).Cutting;
    const double strength = held.IsWhole() ? held.Behind.Puncture : held.Strength;
    needle.Puncture = std::max(0.0, strength + front - here);
    needle.PuncturedLabel = held.Behind.Label;
  }
}

/**
 * Returns the first place between two places that resists. `to` must resist, and `from` must not.
 */
Vector3 FindFirstResistance(
  const NeedleTissueReader& reader, const Vector3& from, const Vector3& to) noexcept
{
  Vector3 before = from;
  Vector3 behind = to;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i)
  {
    const Vector3 middle = 0.5 * (before + behind);
    (reader.At(middle).Resists() ? behind : before) = middle;
  }
  return behind;
}

/**
 * Begins the track where the tissue begins, at most as far back as the needle was pushed in. A
 * surface of the scalars holds over some voxels, so a needle that breaks through it is already in
 * tissue.
 */
void BeginTrack(const NeedleTissueReader& reader, double pushed, NeedleState& needle) noexcept
{
  const double step = reader.ComputeStep(needle.Axis);
  const double most = std::min(pushed, MostBack * step);
  const Vector3 tip = needle.Entry;
  const auto behind = [&](double length) { return tip - length * needle.Axis; };
  double back = 0.0;
  for (bool resists = true; resists && back < most;)
  {
    const double further = std::min(back + step, most);
    resists = reader.At(behind(further)).Resists();
    back = resists
      ? further
      : Dot(tip - FindFirstResistance(reader, behind(further), behind(back)), needle.Axis);
  }
  needle.Entry = behind(back);
  needle.Depth = needle.Deepest = back;
  for (double depth = 0.0; depth < back + step; depth += step)
  {
    const double at = std::min(depth, back);
    const NeedleTissue tissue = reader.At(behind(back - at));
    needle.Track.Append(at, tissue.Shaft, tissue.Label);
  }
}

/**
 * If the tick has broken through a surface, or has moved into tissue that resists, inserts the
 * needle and repeats the tick from `before`. Must be called after a tick of the method with a free
 * needle.
 */
void EnterNeedle(
  const HapticModel& model, ServoState& state, const FreeTick& before, TickRecord& record) noexcept
{
  NeedleState& needle = state.Needle;
  const NeedleTissueReader reader(model, state.DataTime, state.Labels);
  needle.IsOutside = needle.IsOutside || !reader.At(before.Proxy).Resists();
  UpdateMotion(record.Tip - before.Tip, needle.Motion);
  const HeldAt held = ComputeHeld(model, reader, needle, before, record);
  const bool isHeld = record.NormalForce > Law::ForceEpsilon;
  needle.Normal = isHeld ? record.Normal : Vector3{};
  if (!needle.IsOutside)
  {
    return;
  }
  const Vector3 axis = FindAxis(state, record.Tip - before.Proxy, held.Normal);
  const double pushed = needle.Pushed;
  if (IsThrough(model, held, before, axis, record, needle.Pushed))
  {
    Begin(state, before.Proxy, axis, held.Normal, before.Stiffness);
    SetPuncture(model, reader, held, needle);
    BeginTrack(reader, pushed, needle);
    StepNeedle(model, state, record);
    return;
  }
  const bool isFree = !isHeld && record.SurfaceStrength <= Law::ForceEpsilon &&
    before.SurfaceStrength <= Law::ForceEpsilon &&
    Dot(record.Tip - before.Proxy, axis) > SmallestLag;
  if (!isFree)
  {
    return;
  }
  const NeedleTissue there = reader.At(record.Proxy);
  // If a label with a strength has a surface, the surface is within a kernel length.
  const Vector3 behind = record.Proxy - model.KernelLengthAlong(axis) * axis;
  const bool hasSurface = there.Puncture > 0.0 && reader.At(behind).Label != there.Label;
  const double stiffness = there.Resists() ? reader.Stiffness(record.Proxy) : 0.0;
  if (hasSurface || !(stiffness > HapticModel::MinimumStiffness))
  {
    return;
  }
  const bool isAtOnce = !reader.At(before.Proxy).Resists();
  const Vector3 entry =
    isAtOnce ? FindFirstResistance(reader, before.Proxy, record.Proxy) : before.Proxy;
  const bool hasNormal = record.GradientMagnitude > 0.0;
  Begin(state, entry, axis, hasNormal ? record.Normal : Vector3{}, stiffness);
  BeginTrack(reader, isAtOnce ? 0.0 : model.KernelLengthAlong(axis), needle);
  StepNeedle(model, state, record);
}

} // namespace

BakedNeedle::BakedNeedle(NeedleDescription description)
  : Description(std::move(description))
  , Forces({ this->Description.ShaftFriction, this->Description.CuttingForce })
{
}

const ToolColumns& BakedNeedle::Columns()
{
  // Never destroyed, because a filter may exist until the process ends.
  static const auto* const columns = new ToolColumns{ { "ForbiddenTouches", "", 1, false,
    [](const HapticModel&, const TickRecord& record, double* numbers)
    { numbers[0] = record.ToolNumbers[0]; } } };
  return *columns;
}

bool BakedNeedle::IsSame(const BakedTool& other) const
{
  const auto* const needle = dynamic_cast<const BakedNeedle*>(&other);
  const NeedleDescription& a = this->Description;
  return needle && IsSameLine(a.ShaftFriction, needle->Description.ShaftFriction) &&
    IsSameLine(a.CuttingForce, needle->Description.CuttingForce) &&
    a.HasCuttingForce == needle->Description.HasCuttingForce &&
    a.LateralStrength == needle->Description.LateralStrength;
}

bool BakedNeedle::Step(const ToolTick& tick) const noexcept
{
  ServoState& state = tick.State;
  if (state.Needle.IsInserted)
  {
    StepNeedle(tick.Model, state, tick.Record);
  }
  else
  {
    const FreeTick before(state);
    const bool isFelt = state.Enabled;
    tick.FeelPoint();
    if (isFelt)
    {
      EnterNeedle(tick.Model, state, before, tick.Record);
    }
  }
  tick.Record.ToolNumbers[0] = state.Needle.Touches;
  return state.Needle.IsInserted;
}

bool BakedNeedle::Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
  ToolMemory* /*memory*/) const noexcept
{
  const bool wasInserted = state.Needle.IsInserted;
  CarryNeedle(from, to, state.Needle);
  return wasInserted && !state.Needle.IsInserted;
}

void BakedNeedle::AppendTables(std::vector<MemoryRange>& tables) const
{
  tables.push_back({ this, sizeof(*this) });
  tables.push_back(
    { this->Forces.GetMemory(), this->Forces.GetMemorySize() - sizeof(this->Forces) });
}

} // namespace VolumeHaptics
