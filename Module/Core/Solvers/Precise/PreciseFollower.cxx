// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseFollower.h"

#include "Core/Solvers/Precise/ProxyDisplacement.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Longest step of tip and proxy (voxels). A fraction of the lag replaces this limit if it is
 * longer.
 */
constexpr double LongestStep = 0.25;
constexpr double SpringFraction = 0.02;
/** A motion of at most this length (voxels) is not checked at its end. */
constexpr double ShortStep = 1e-3;
/**
 * A motion of at most LongestCreep (voxels) is not checked at its end if the next motions are at
 * most LongestRest long.
 */
constexpr double LongestCreep = 0.03;
constexpr double LongestRest = 2e-3;

/**
 * The stored sample is used until the proxy is this distance (voxels) away from it. Each tick
 * counts as at least LeastSampleDistance, so that a sample of another model is not used for long
 * when a recording is replayed.
 */
constexpr double LongestSampleDistance = 1e-3;
constexpr double LeastSampleDistance = LongestSampleDistance / 32.0;
/**
 * LongestSampleDistance at walls of labels. It is larger, because these walls have bumps of a tenth
 * of a voxel anyway.
 */
constexpr double LongestWallDistance = 4e-3;

/** Limits of a prediction. A prediction outside them would not save the sample that checks it. */
constexpr double LeastPrediction = 0.5;
constexpr double MostPrediction = 1.5;
/**
 * Fraction of a tick's prediction error that is learned at once. The rest is learned in the next
 * ticks.
 */
constexpr double LearnedFraction = 0.5;

/** A smaller change of the force (N) is no leap. */
constexpr double LeastLeap = 0.02;

/** Tolerance of a quotient, so that different rounding on another machine does not add a step. */
constexpr double Rounding = 1e-9;
/** At most this many motions may lengthen the spring while the tip stays. */
constexpr int MostSetbacks = 8;

} // namespace

void PreciseFollower::Solve(const Vector3& tip) noexcept
{
  const Vector3 from = this->State.ReachedTip;
  const Vector3 lag = from - this->Proxy;
  if (this->State.CachedSampleDistance >
    (this->IsOfWalls ? LongestWallDistance : LongestSampleDistance))
  {
    this->LookAround(lag, this->ComputeTouched(lag));
    this->Refresh(Norm(lag));
  }
  if (Law::IsFelt(this->State.Here))
  {
    this->Refreshed = this->State.Spring.GetEffective() * (this->Proxy - from);
  }
  Vector3 at = from;
  for (double steps = 2.0; steps > 1.0;)
  {
    const Vector3 displacement = tip - at;
    const double voxels = this->Field.Voxels(displacement);
    steps = 1.0;
    if (voxels > LongestStep * (1.0 + Rounding) &&
      !(this->Field.IsBeyond(at, tip) && this->Field.IsBeyond(this->Proxy, tip)))
    {
      // Far from the proxy, longer steps do not turn the spring more.
      const double longest =
        std::max(LongestStep, SpringFraction * this->Field.Voxels(at - this->Proxy));
      steps = std::ceil(voxels / longest - Rounding);
    }
    at = steps > 1.0 ? at + (1.0 / steps) * displacement : tip;
    if (!this->Settle(at))
    {
      return;
    }
  }
}

void PreciseFollower::TakeOver(const Surface& there, const Vector3& motion) noexcept
{
  const Vector3 lag = this->State.ReachedTip - this->Proxy;
  this->State.Here = this->Field.Look(this->Proxy, there, lag, this->ComputeTouched(lag),
    this->State.CachedSampleDistance + this->Field.Voxels(motion));
  this->State.CachedSampleDistance = 0.0;
  this->Refresh(Norm(lag));
}

void PreciseFollower::Write(TickRecord& record) const noexcept
{
  static_cast<MaterialPoint&>(record) = this->State.Here;
  record.Proxy = this->Proxy;
  if (!Law::IsFelt(this->State.Here))
  {
    return;
  }
  record.Stiffness = this->State.Spring.GetEffective();
  record.Slope = this->State.Spring.Tissue;
  record.Force = record.Stiffness * (this->Proxy - this->State.ReachedTip);
  record.NormalForce = this->Last.Normal;
  record.FrictionForce = this->Last.Friction;
  record.DragForce = std::min(this->State.Here.Viscosity, this->Last.Excess);
  if (this->Pushes && this->Last.Normal > Law::ForceEpsilon)
  {
    record.Contact = this->WentThrough
      ? ContactState::Penetrating
      : (this->Slid ? ContactState::Sliding : ContactState::Sticking);
  }
}

void PreciseFollower::WriteLeap(
  const SpringBefore& before, double carried, TickRecord& record) const noexcept
{
  record.MayLeap = true;
  record.ForceBefore = before.Force;
  // Without a leap, the force changes at most by the change of its spring and by the friction of
  // this change.
  const double k = std::max({ before.Stiffness, record.Stiffness, this->State.Spring.Tissue });
  const double mu = std::max(before.Friction, record.Friction);
  const double motion = Norm(record.Tip - before.Tip) + carried;
  const double most = k * std::sqrt(1.0 + mu * mu) * motion + LeastLeap;
  // A change due to another model is no leap. With the same model, the tissue at the proxy can only
  // change by a motion in the last tick whose end was not sampled.
  const Vector3 change = record.Force -
    (before.IsOfAnotherModel ? this->Refreshed.value_or(before.Force) : before.Force);
  const double square = Dot(change, change);
  if (square > most * most)
  {
    record.Leap = (1.0 - most / std::sqrt(square)) * change;
    record.LeapStiffness = k;
  }
}

TouchedMaterial PreciseFollower::ComputeTouched(const Vector3& lag) const noexcept
{
  const PrecisePoint& here = this->State.Here;
  const bool holds = here.SurfaceStrength > 0.0 && Dot(lag, here.Normal) > 0.0;
  const bool dragsOn = here.Viscosity > 0.0 && here.FarLasts > 0.0;
  return { Law::IsFelt(here) ? &here : nullptr, holds || dragsOn, holds };
}

void PreciseFollower::LookAround(const Vector3& lag, const TouchedMaterial& touched) noexcept
{
  this->State.Here = this->Field.Look(this->Proxy, lag, touched, this->State.CachedSampleDistance);
  this->State.CachedSampleDistance = 0.0;
}

void PreciseFollower::Refresh(double lag) noexcept
{
  PassiveSpring& spring = this->State.Spring;
  const double reserve = spring.Reserve;
  spring.DropReserve();
  PassOn(spring, this->State.Here.Stiffness, lag);
  spring.Reserve += spring.Tension > 0.0 && lag > 0.0 ? reserve : 0.0;
  this->Field.LimitDrag(spring, lag, this->State.Here);
}

bool PreciseFollower::Settle(const Vector3& tip) noexcept
{
  const Vector3 before = this->State.ReachedTip;
  if (!Law::IsFelt(this->State.Here))
  {
    // Only the tip's step stretches the spring, because a proxy that follows the tip has no force.
    this->State.Spring.Tension = 0.0;
  }
  if (this->State.Spring.Tension < 1.0)
  {
    this->State.Spring.Stretch(Norm(before - this->Proxy), Norm(tip - this->Proxy));
  }
  this->State.ReachedTip = tip;
  bool isFirst = true;
  const Vector3 start = this->Proxy;
  Vector3 firstDisplacement;
  double lastVoxels = 0.0;
  Vector3 lastDisplacement;
  int setbacks = 0;
  for (;;)
  {
    if (this->IsTwoSided && Dot(tip - this->Proxy, this->State.Here.Normal) < 0.0)
    {
      const double lag = Norm(tip - this->Proxy);
      this->LookAround(tip - this->Proxy, {});
      PassOn(this->State.Spring, this->State.Here.Stiffness, lag);
      this->Field.LimitDrag(this->State.Spring, lag, this->State.Here);
    }
    Motion motion = this->Plan(tip, isFirst ? &before : nullptr);
    if (isFirst)
    {
      isFirst = false;
      firstDisplacement = motion.Displacement;
      if (motion.IsHeld)
      {
        this->Lengthen(motion, this->State.StepPrediction, tip);
      }
    }
    const double voxels = this->Field.Voxels(motion.Displacement);
    this->Record(voxels);
    // While the tip rests, each motion is shorter than the previous one by a constant factor, which
    // determines the sum of this motion and all later ones.
    const double rate = lastVoxels > 0.0 ? voxels / lastVoxels : 1.0;
    const bool isLast = voxels <= LongestCreep && voxels * rate <= LongestRest && rate < 0.5;
    if (isLast && Dot(motion.Displacement, lastDisplacement) > 0.0)
    {
      this->Lengthen(motion, 1.0 / (1.0 - rate), tip);
    }
    if (isLast || voxels <= ShortStep)
    {
      this->Creep(motion, tip);
      this->Learn(firstDisplacement, this->Proxy - start, motion.IsHeld && lastVoxels > 0.0);
      return true;
    }
    if (!this->Field.CanGoOn() || setbacks > MostSetbacks)
    {
      this->LooksAreSpent = true;
      this->State.ReachedTip = tip - motion.Displacement;
      this->State.Spring.Stretch(
        Norm(tip - this->Proxy), Norm(this->State.ReachedTip - this->Proxy));
      return false;
    }
    const double fraction = voxels > LongestStep ? LongestStep / voxels : 1.0;
    const Arrival end = this->Field.Arrive({ this->Proxy, this->State.Spring, this->State.Level,
                                             this->ComputeTouched(tip - this->Proxy) },
      motion, fraction, tip);
    const Vector3 lag = tip - end.Proxy;
    const Vector3 lagBefore = tip - this->Proxy;
    // Only a return to the level may lengthen the spring, and only a few times.
    setbacks += Dot(lag, lag) > Dot(lagBefore, lagBefore) ? 1 : 0;
    lastVoxels = fraction * voxels;
    lastDisplacement = motion.Displacement;
    this->Proxy = end.Proxy;
    this->State.Here = end.There;
    this->State.CachedSampleDistance = end.CachedSampleDistance;
    this->State.Spring = end.Spring;
  }
}

Motion PreciseFollower::Plan(const Vector3& tip, const Vector3* tipBefore) noexcept
{
  const PrecisePoint& here = this->State.Here;
  Motion motion;
  const Vector3 lag = tip - this->Proxy;
  this->Pushes = false;
  this->Last = Balance{};
  if (!Law::IsFelt(here))
  {
    this->State.IsHeld = false;
    motion.Displacement = lag;
    motion.IsFree = true;
    return motion;
  }
  const double k = this->State.Spring.GetEffective();
  const SplitLag split = Law::Split(lag, here.Normal);
  this->Pushes = split.Push > 0.0;
  this->Last = Law::Weigh(here, k, split);
  motion.IsHeld = this->Pushes && !this->Last.IsThrough && here.Slope != 0.0;
  motion.IsFree = this->Last.Normal == 0.0 && here.Viscosity == 0.0;
  const bool turns = here.Friction * this->Last.Normal + here.Viscosity > 0.0;
  if (motion.IsFree)
  {
    motion.Displacement = lag;
  }
  else
  {
    const auto plain = [&] { return Law::Move(here, k, split, this->Last, Vector3{}); };
    motion.Displacement = tipBefore && turns && this->Last.Excess > here.Viscosity
      ? ProxyDisplacement::Compute(
          here, k, this->Field.GetLongestMean(), *tipBefore - this->Proxy, lag, split, plain)
      : plain();
  }
  if (!motion.IsHeld)
  {
    this->State.IsHeld = false;
    return motion;
  }
  // The proxy may have left the surface and touched it again.
  const double inward = Dot(motion.Displacement, here.Normal);
  if (!this->State.IsHeld ||
    inward * inward > Rounding * Rounding * Dot(motion.Displacement, motion.Displacement) ||
    !this->Field.IsOfLevel(here, this->State.Level))
  {
    this->State.IsHeld = true;
    this->State.Level = here.Value + here.Slope * inward;
    return motion;
  }
  motion.Displacement += this->Field.ToLevel(here, k, this->State.Level, lag) * here.Normal;
  return motion;
}

void PreciseFollower::Record(double voxels) noexcept
{
  const bool moves = voxels > 0.0 && this->Pushes;
  this->WentThrough = this->WentThrough || (moves && this->Last.IsThrough);
  this->Slid = this->Slid || (moves && this->Last.Slides);
}

void PreciseFollower::Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept
{
  const Vector3 displacement = factor * motion.Displacement;
  const double force = this->State.Spring.GetEffective() * Norm(tip - this->Proxy - displacement);
  const PrecisePoint& here = this->State.Here;
  if (force <
    here.SurfaceStrength * std::sqrt(1.0 + here.Friction * here.Friction) + here.Viscosity)
  {
    motion.Displacement = displacement;
  }
}

void PreciseFollower::Learn(
  const Vector3& firstDisplacement, const Vector3& displacement, bool isJudged) noexcept
{
  if (isJudged)
  {
    const double prediction =
      Dot(firstDisplacement, displacement) / Dot(firstDisplacement, firstDisplacement);
    this->State.StepPrediction += LearnedFraction *
      (std::clamp(prediction, LeastPrediction, MostPrediction) - this->State.StepPrediction);
  }
  else if (!this->State.IsHeld)
  {
    this->State.StepPrediction = 1.0;
  }
}

void PreciseFollower::Creep(const Motion& motion, const Vector3& tip) noexcept
{
  PrecisePoint& here = this->State.Here;
  const double voxels = this->Field.GetVoxelsPerMeter() * Norm(motion.Displacement);
  this->State.CachedSampleDistance += std::max(voxels, LeastSampleDistance);
  this->Proxy = motion.IsFree ? tip : this->Proxy + motion.Displacement;
  here.Value += here.Slope * Dot(motion.Displacement, here.Normal);
  if (motion.IsFree)
  {
    this->State.Spring.Relax(here.Stiffness);
  }
}

} // namespace VolumeHaptics
