// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Needle/NeedleTool.h"

#include "Core/Law/MaterialLaw.h"
#include "Core/Tools/Needle/NeedleTissue.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Limit of the steps in a tick. A needle that needs more steps ends with the force of the tissue
 * that it has reached.
 */
constexpr int MostNeedleSteps = 64;
/**
 * Limit of the steps of Skip() in a tick, about a thousand voxels. The next tick continues from
 * there.
 */
constexpr int MostSkippedSteps = 4096;
/** Accuracy of boundaries, as a fraction of a step. It is a millionth of a voxel. */
constexpr double BoundaryFraction = 4e-6;
/** Depth (m) from which on the lateral hold has its full strength. */
constexpr double HoldDepth = 1e-3;

/** Moves an inserted needle along its axis in one tick, and computes the force. */
class InsertedNeedle
{
public:
  InsertedNeedle(const HapticModel& model, ServoState& state, const Vector3& tip) noexcept
    : Needle(state.Needle)
    , Reader(model, state.DataTime, state.Labels)
    , Tip(tip)
    , Proxy(state.Proxy)
    , Stiffness(Law::Capped(state.Needle.Stiffness, model.Caps.Stiffness))
    , LateralStrength(GetNeedle(model).Description.LateralStrength)
    , Axis(state.HasOrientation ? AxisOfStylus(state.Orientation) : state.Needle.Axis)
    , KernelLength(model.KernelLengthAlong(this->Axis))
  {
    this->Needle.Axis = this->Axis;
    this->Step = this->Reader.ComputeStep(this->Axis);
    this->Here = this->Reader.At(this->Proxy);
  }

  void Update() noexcept
  {
    const double along = this->ComputeRest();
    const double depth = this->Needle.Depth;
    if (along > 0.0)
    {
      this->Advance();
    }
    else
    {
      this->Withdraw();
    }
    this->Moved = this->Needle.Depth - depth;
    this->HoldAcross();
  }

  void Write(TickRecord& record) const noexcept
  {
    const Vector3& axis = this->Axis;
    const Vector3 lag = this->Tip - this->Proxy;
    const double along = Dot(lag, axis);
    record.Proxy = this->Proxy;
    record.Force = (-this->Stiffness) * lag;
    record.Normal = axis;
    record.Stiffness = this->Stiffness;
    record.Friction = 0.0;
    record.GradientMagnitude = 0.0;
    record.SurfaceValue = record.MediumValue = this->Here.Value;
    record.Viscosity = this->Here.Cutting;
    record.SurfaceStrength = this->Strength;
    record.NormalForce = this->Stiffness * std::abs(along);
    record.FrictionForce = this->Stiffness * Norm(lag - along * axis);
    record.ShaftForce = record.DragForce = this->Needle.Track.Sum(this->Needle.Depth);
    record.Depth = this->Needle.Depth;
    record.IsUnfinished = this->IsUnfinished;
    record.Contact = this->Moved > 0.0 ? ContactState::Penetrating
      : this->Moved < 0.0              ? ContactState::Sliding
                                       : ContactState::Sticking;
  }

private:
  /** Returns how far (m) the tip is ahead of the proxy. */
  double ComputeRest() const noexcept { return Dot(this->Tip - this->Proxy, this->Axis); }

  Vector3 Ahead(double length) const noexcept { return this->Proxy + length * this->Axis; }

  /** Moves the needle forward by a length (m), into the given tissue. */
  void MoveBy(double length, const NeedleTissue& into) noexcept
  {
    this->Proxy = this->Ahead(length);
    this->Needle.Depth += length;
    this->Needle.Deepest = std::max(this->Needle.Deepest, this->Needle.Depth);
    this->Needle.Track.Append(this->Needle.Depth, into.Shaft, into.Label);
    this->Here = into;
  }

  /**
   * Returns whether a boundary in front of the tip holds the needle. If it does not, the tip passes
   * it.
   */
  bool IsHeldAtBoundary(double pull, double shaft) noexcept
  {
    this->Strength = this->Needle.Puncture;
    if (pull <= this->Here.Cutting + shaft + this->Needle.Puncture + Law::ForceEpsilon)
    {
      return true;
    }
    this->Needle.Puncture = this->Strength = 0.0;
    this->Needle.PuncturedAt = this->Needle.Depth;
    const double gap = BoundaryFraction * this->Step;
    this->MoveBy(gap, this->Reader.At(this->Ahead(gap)));
    return false;
  }

  /** Moves the needle to the boundary within a length, or through it if this needs no force. */
  void MeetBoundary(double length) noexcept
  {
    const double gap = BoundaryFraction * this->Step;
    double before = 0.0;
    double behind = length;
    NeedleTissue next = this->Reader.At(this->Ahead(behind));
    while (behind - before > gap)
    {
      const double middle = 0.5 * (before + behind);
      const NeedleTissue tissue = this->Reader.At(this->Ahead(middle));
      const bool isBehind = tissue.Label != this->Here.Label;
      (isBehind ? behind : before) = middle;
      next = isBehind ? tissue : next;
    }
    const bool isOpen = next.Label == this->Needle.PuncturedLabel &&
      this->Needle.Depth + before < this->Needle.PuncturedAt + this->KernelLength;
    if (next.Puncture > 0.0 && !isOpen)
    {
      this->MoveBy(before, this->Here);
      this->Needle.Puncture = next.Puncture;
      this->Needle.PuncturedLabel = next.Label;
      return;
    }
    this->MoveBy(behind, next);
  }

  /** Returns the part of a length that is in front of the stand-off of forbidden labels. */
  double StopAtForbidden(double length) noexcept
  {
    if (!this->Reader.IsForbidden(this->Ahead(length)))
    {
      this->IsStopped = false;
      return length;
    }
    this->IsStopped = true;
    double before = 0.0;
    double behind = length;
    while (behind - before > BoundaryFraction * this->Step)
    {
      const double middle = 0.5 * (before + behind);
      (this->Reader.IsForbidden(this->Ahead(middle)) ? behind : before) = middle;
    }
    return before;
  }

  /** Counts how often a forbidden label has stopped the needle. */
  void CountTouch() noexcept
  {
    this->Needle.Touches += this->IsStopped && !this->Needle.IsTouching ? 1 : 0;
    this->Needle.IsTouching = this->IsStopped;
  }

  void Advance() noexcept
  {
    // The needle may have slid into other tissue.
    this->Needle.Track.Append(this->Needle.Depth, this->Here.Shaft, this->Here.Label);
    const double k = this->Stiffness;
    double held = 0.0; // force (N) with which the tissue holds the needle here
    for (int i = 0; i < MostNeedleSteps; ++i)
    {
      const double pull = k * this->ComputeRest();
      const double shaft = this->Needle.Track.Sum(this->Needle.Depth);
      if (this->Needle.Puncture > 0.0)
      {
        if (this->IsHeldAtBoundary(pull, shaft))
        {
          this->CountTouch();
          return;
        }
        continue;
      }
      this->Strength = this->Reader.SurfaceStrength(this->Proxy, this->Axis);
      held = this->Here.Cutting + shaft + this->Strength;
      if (pull <= held + Law::ForceEpsilon)
      {
        this->CountTouch();
        return;
      }
      const double wanted = std::min(this->Step, (pull - held) / (k + this->Here.Shaft));
      const double length = this->StopAtForbidden(wanted);
      const NeedleTissue next = this->Reader.At(this->Ahead(length));
      if (next.Label != this->Here.Label)
      {
        this->MeetBoundary(length);
      }
      else
      {
        this->MoveBy(length, next);
      }
      if (this->IsStopped)
      {
        this->CountTouch();
        return;
      }
    }
    this->IsUnfinished = true;
    this->Skip(std::max(0.0, k * this->ComputeRest() - held) / k);
  }

  /**
   * Moves the needle by `length` (m) if the tick has no steps left. All tissue on the way counts as
   * that at the present place, so that the force does not exceed what the tissue can hold. Stops at
   * forbidden labels; if there are any, makes at most MostSkippedSteps steps.
   */
  void Skip(double length) noexcept
  {
    const double part = this->Reader.HasForbidden() ? this->Step : length;
    for (int i = 0; i < MostSkippedSteps && length > 0.0 && !this->IsStopped; ++i)
    {
      const double wanted = std::min(part, length);
      this->MoveBy(this->StopAtForbidden(wanted), this->Here);
      length -= wanted;
    }
    this->CountTouch();
  }

  void Withdraw() noexcept
  {
    this->CountTouch();
    const double k = this->Stiffness;
    NeedleTrack& track = this->Needle.Track;
    for (int i = 0; i <= NeedleTrack::Most; ++i)
    {
      const double pull = -k * this->ComputeRest();
      const double shaft = track.Sum(this->Needle.Depth);
      if (pull <= shaft + Law::ForceEpsilon)
      {
        return;
      }
      const NeedleStretch last = track.Last();
      const double room = std::max(0.0, this->Needle.Depth - last.Begin);
      // The friction decreases as the depth decreases.
      const bool isStable = k > last.Shaft;
      const double length = isStable ? std::min(room, (pull - shaft) / (k - last.Shaft)) : room;
      this->Proxy = this->Ahead(-length);
      this->Needle.Depth -= length;
      this->Needle.Puncture = length > 0.0 ? 0.0 : this->Needle.Puncture;
      if (length < room)
      {
        return;
      }
      if (track.GetSize() == 1)
      {
        this->Needle = NeedleState{};
        this->Proxy = this->Tip;
        return;
      }
      this->Needle.Depth = last.Begin;
      track.SetSize(track.GetSize() - 1);
    }
  }

  void HoldAcross() noexcept
  {
    if (!this->Needle.IsInserted)
    {
      return;
    }
    const Vector3 lag = this->Tip - this->Proxy;
    const Vector3 across = lag - Dot(lag, this->Axis) * this->Axis;
    const double fraction =
      this->Needle.Puncture > 0.0 ? 1.0 : std::min(1.0, this->Needle.Depth / HoldDepth);
    const double pull = this->Stiffness * Norm(across);
    const double strength = fraction * this->LateralStrength;
    if (pull > strength)
    {
      this->Proxy += (1.0 - strength / pull) * across;
    }
  }

  NeedleState& Needle;
  const NeedleTissueReader Reader;
  const Vector3 Tip;
  Vector3 Proxy;
  const double Stiffness;
  const double LateralStrength;
  const Vector3 Axis;
  const double KernelLength; ///< length of the kernel along the axis (m)
  double Step = 0.0;
  NeedleTissue Here;     ///< tissue at the tip
  double Strength = 0.0; ///< strength (N) of the boundary or surface that holds the tip
  double Moved = 0.0;    ///< length moved forward (m)
  bool IsStopped = false;
  bool IsUnfinished = false;
};

} // namespace

void StepNeedle(const HapticModel& model, ServoState& state, TickRecord& record) noexcept
{
  InsertedNeedle needle(model, state, record.Tip);
  needle.Update();
  needle.Write(record);
  if (!state.Needle.IsInserted)
  {
    // The method restarts.
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = record.Tip;
  }
}

void CarryNeedle(const HapticModel& from, const HapticModel& to, NeedleState& needle) noexcept
{
  const HapticSettings& was = from.Baked->Settings;
  const HapticSettings& is = to.Baked->Settings;
  if (!dynamic_cast<const BakedNeedle*>(to.Baked->Tool.get()) || was.Method != is.Method)
  {
    needle = NeedleState{};
    return;
  }
  const auto turn = [&](const Vector3& v)
  { return Transpose(to.DeviceToWorldRotation) * (from.DeviceToWorldRotation * v); };
  const double scale = from.WorldUnitsPerMeter / to.WorldUnitsPerMeter;
  needle.Axis = turn(needle.Axis);
  needle.Motion = scale * turn(needle.Motion);
  needle.Normal = turn(needle.Normal);
  needle.Entry = to.WorldToDevice(from.DeviceToWorld(needle.Entry));
  for (double* const length :
    { &needle.Depth, &needle.Deepest, &needle.PuncturedAt, &needle.Pushed })
  {
    *length *= scale;
  }
  for (int i = 0; i < needle.Track.GetSize(); ++i)
  {
    needle.Track[i].Begin = static_cast<float>(scale * needle.Track[i].Begin);
  }
}

} // namespace VolumeHaptics
