// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Needle/NeedleEntry.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/Tools/Needle/NeedleTissue.h"
#include "Core/Tools/Needle/NeedleTool.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** If the needle breaks through a surface, the lag falls by at least this fraction. */
constexpr double BreakFraction = 1e-3;
/** A surface that still holds is punctured when the proxy was pushed this far (kernel lengths). */
constexpr double MostPushed = 2.0;
constexpr double SmallestLag = 1e-9; // m, the smallest lag
/** A surface gives way at no less than this fraction of its strength. */
constexpr double WholeFraction = 0.99;
/** The hand's direction is averaged over this length of its motion (m). */
constexpr double MotionLength = 1e-3;
/**
 * A motion whose cosine to the normal is smaller runs along the surface, and does not give the
 * axis.
 */
constexpr double LeastPush = 0.2;
/** The farthest beginning of a track behind the tip (steps). */
constexpr double MostBack = 64.0;

/** Adds a step to the hand's motion (m): older motions count less. */
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
 * Returns the unit direction of a needle that is inserted now; 0 if there is none.
 * @param normal normal of the surface that holds the needle; 0 if there is none
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

/** A surface that holds a free needle, in the tick that may break through it. */
struct HeldAt
{
  Vector3 Normal;        ///< unit, into the structure; 0: no surface holds
  double Push = 0.0;     ///< N, the spring's push against the surface
  NeedleTissue Behind;   ///< the tissue of the surface; not read without a push
  double Strength = 0.0; ///< T W_d, N
  bool IsWhole() const noexcept
  {
    // The surface holds with all the strength of the label behind it, whatever W_d is.
    return this->Behind.Puncture > 0.0 && this->Push >= WholeFraction * this->Behind.Puncture;
  }
};

HeldAt ComputeHeld(const HapticModel& model, const NeedleTissueReader& reader,
  const NeedleState& needle, const FreeTick& before, const TickRecord& record) noexcept
{
  HeldAt held;
  // PRECISE may pass through a surface within a tick, and has no normal force after it.
  held.Normal = record.NormalForce > Law::ForceEpsilon ? record.Normal : needle.Normal;
  held.Push = before.Stiffness * Dot(record.Tip - before.Proxy, held.Normal);
  if (held.Push > 0.0)
  {
    held.Behind = reader.At(before.Proxy + model.KernelLengthAlong(held.Normal) * held.Normal);
  }
  held.Strength = std::max(before.SurfaceStrength, record.SurfaceStrength);
  return held;
}

/** Returns whether a tick of the free law has broken through the surface that held the needle. */
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
 * Sets the force of a surface at its puncture, beside R at the entry. The entry may be behind the
 * boundary; like the free law, this uses T and R in front of the surface.
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
 * Returns the first place on a way that resists. The end of the way is known to resist, and its
 * beginning not to resist.
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
 * Begins the track where the tissue begins, at most as far back as the needle was pushed. A surface
 * of the scalars holds over some voxels, so a needle that breaks through it is in tissue already.
 */
void BeginTrack(const NeedleTissueReader& reader, double pushed, NeedleState& needle) noexcept
{
  const double step = reader.ComputeStep(needle.Axis);
  const int most = static_cast<int>(std::min(pushed / step, MostBack));
  const Vector3 tip = needle.Entry;
  int back = 0;
  while (back < most && reader.At(tip - (back + 1) * step * needle.Axis).Resists())
  {
    ++back;
  }
  needle.Entry = tip - back * step * needle.Axis;
  needle.Depth = needle.Deepest = back * step;
  for (int i = 0; i <= back; ++i)
  {
    const NeedleTissue tissue = reader.At(needle.Entry + i * step * needle.Axis);
    needle.Track.Append(i * step, tissue.Shaft, tissue.Label);
  }
}

} // namespace

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
  // A label with a strength has its surface, if any, within a kernel length.
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

} // namespace VolumeHaptics
