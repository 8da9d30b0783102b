// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseFollower.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Voxels that tip and proxy go at a time; the tip may go this share of the spring, if that is more.
 */
constexpr double LongestStep = 0.25;
constexpr double SpringShare = 0.02;
/** A motion this short (voxels) is not judged at its end. */
constexpr double ShortStep = 1e-3;
/** Nor is a longer one, up to this, that would leave so little to be done. */
constexpr double LongestCreep = 0.03;
constexpr double LongestRest = 2e-3;

/**
 * Voxels that a proxy may creep before its place is looked up again, and what a tick counts at
 * least: a place that is kept from another model, by a recording that is played there, does not
 * last.
 */
constexpr double LongestStray = 1e-3;
constexpr double LeastStray = LongestStray / 32.0;

/** A bolder guess is not worth its judgement. */
constexpr double LeastGain = 0.5;
constexpr double MostGain = 1.5;
/** Of a new gain: what it leaves over shows in the next tick's. */
constexpr double LearnedShare = 0.5;

/** Of a quotient: a way of just so many steps is not to be one step more on another machine. */
constexpr double Rounding = 1e-9;
/** Motions at one tip that may lengthen the spring. */
constexpr int MostSetbacks = 8;

} // namespace

void Follower::Follow(const Vector3& tip) noexcept
{
  const Vector3 from = this->State.ReachedTip;
  const Vector3 lag = from - this->Proxy;
  if (this->State.Stray > LongestStray)
  {
    this->LookAround(lag);
    this->Refresh(Norm(lag));
  }
  Vector3 at = from;
  for (double steps = 2.0; steps > 1.0;)
  {
    const Vector3 way = tip - at;
    const double voxels = this->Field.Voxels(way);
    steps = 1.0;
    if (voxels > LongestStep * (1.0 + Rounding) &&
      !(this->Field.IsBeyond(at, tip) && this->Field.IsBeyond(this->Proxy, tip)))
    {
      // Far from the proxy a longer step turns the spring no more.
      const double longest =
        std::max(LongestStep, SpringShare * this->Field.Voxels(at - this->Proxy));
      steps = std::ceil(voxels / longest - Rounding);
    }
    at = steps > 1.0 ? at + (1.0 / steps) * way : tip;
    if (!this->Settle(at))
    {
      return;
    }
  }
}

void Follower::Write(TickRecord& record) const noexcept
{
  static_cast<Place&>(record) = this->State.Here;
  record.Proxy = this->Proxy;
  if (!Law::IsFelt(this->State.Here))
  {
    return;
  }
  record.Stiffness = this->State.Spring.GetEffective();
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

void Follower::LookAround(const Vector3& lag) noexcept
{
  this->State.Here = this->Field.Look(this->Proxy, lag);
  this->State.Stray = 0.0;
}

void Follower::Refresh(double lag) noexcept
{
  PassiveSpring& spring = this->State.Spring;
  const double reserve = spring.Reserve;
  spring.DropReserve();
  PassOn(spring, this->State.Here.Stiffness, lag);
  spring.Reserve += spring.Tension > 0.0 && lag > 0.0 ? reserve : 0.0;
}

bool Follower::Settle(const Vector3& tip) noexcept
{
  const Vector3 before = this->State.ReachedTip;
  if (!Law::IsFelt(this->State.Here))
  {
    // All slack, but for what the hand does now: a proxy on its way to the tip brings no force
    // along.
    this->State.Spring.Tension = 0.0;
  }
  if (this->State.Spring.Tension < 1.0)
  {
    this->State.Spring.Stretch(Norm(before - this->Proxy), Norm(tip - this->Proxy));
  }
  this->State.ReachedTip = tip;
  bool isFirst = true;
  const Vector3 start = this->Proxy;
  Vector3 firstWay;
  double lastVoxels = 0.0;
  Vector3 lastWay;
  int setbacks = 0;
  for (;;)
  {
    if (this->IsTwoSided && Dot(tip - this->Proxy, this->State.Here.Normal) < 0.0)
    {
      this->LookAround(tip - this->Proxy);
      PassOn(this->State.Spring, this->State.Here.Stiffness, Norm(tip - this->Proxy));
    }
    Motion motion = this->Plan(tip, isFirst ? &before : nullptr);
    if (isFirst)
    {
      isFirst = false;
      firstWay = motion.Way;
      if (motion.IsHeld)
      {
        this->Lengthen(motion, this->State.Gain, tip);
      }
    }
    const double voxels = this->Field.Voxels(motion.Way);
    this->Note(voxels);
    // Motions at one tip shrink at a rate: what this one and all that follow it would do is known.
    const double rate = lastVoxels > 0.0 ? voxels / lastVoxels : 1.0;
    const bool isLast = voxels <= LongestCreep && voxels * rate <= LongestRest && rate < 0.5;
    if (isLast && Dot(motion.Way, lastWay) > 0.0)
    {
      this->Lengthen(motion, 1.0 / (1.0 - rate), tip);
    }
    if (isLast || voxels <= ShortStep)
    {
      this->Creep(motion, tip);
      this->Learn(firstWay, this->Proxy - start, motion.IsHeld && lastVoxels > 0.0);
      return true;
    }
    if (!this->Field.CanGoOn() || setbacks > MostSetbacks)
    {
      this->LooksAreSpent = true;
      this->State.ReachedTip = tip - motion.Way;
      this->State.Spring.Stretch(
        Norm(tip - this->Proxy), Norm(this->State.ReachedTip - this->Proxy));
      return false;
    }
    const double share = voxels > LongestStep ? LongestStep / voxels : 1.0;
    const Arrival end = this->Field.Arrive(
      { this->Proxy, this->State.Spring, this->State.Level }, motion, share, tip);
    const Vector3 lag = tip - end.Proxy;
    const Vector3 lagBefore = tip - this->Proxy;
    // Only the way back to the level makes the spring longer, and never for long.
    setbacks += Dot(lag, lag) > Dot(lagBefore, lagBefore) ? 1 : 0;
    lastVoxels = share * voxels;
    lastWay = motion.Way;
    this->Proxy = end.Proxy;
    this->State.Here = end.There;
    this->State.Stray = end.Stray;
    this->State.Spring = end.Spring;
  }
}

Motion Follower::Plan(const Vector3& tip, const Vector3* tipBefore) noexcept
{
  const Spot& here = this->State.Here;
  Motion motion;
  const Vector3 lag = tip - this->Proxy;
  this->Pushes = false;
  this->Last = Balance{};
  if (!Law::IsFelt(here))
  {
    this->State.IsHeld = false;
    motion.Way = lag;
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
    motion.Way = lag;
  }
  else
  {
    motion.Way = Law::Move(here, k, split, this->Last, Vector3{});
    if (tipBefore && turns && this->Last.Excess > here.Viscosity)
    {
      motion.Way = MoveAlong(here, k, *tipBefore - this->Proxy, lag, motion.Way);
    }
  }
  if (!motion.IsHeld)
  {
    this->State.IsHeld = false;
    return motion;
  }
  // The surface may have been left and met again on the way.
  const double inward = Dot(motion.Way, here.Normal);
  if (!this->State.IsHeld || std::abs(inward) > Rounding * Norm(motion.Way))
  {
    this->State.IsHeld = true;
    this->State.Level = here.Value + here.Slope * inward;
    return motion;
  }
  motion.Way += this->Field.ToLevel(here, k, this->State.Level, lag) * here.Normal;
  return motion;
}

void Follower::Note(double voxels) noexcept
{
  const bool moves = voxels > 0.0 && this->Pushes;
  this->WentThrough = this->WentThrough || (moves && this->Last.IsThrough);
  this->Slid = this->Slid || (moves && this->Last.Slides);
}

void Follower::Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept
{
  const Vector3 way = factor * motion.Way;
  const double force = this->State.Spring.GetEffective() * Norm(tip - this->Proxy - way);
  const Spot& here = this->State.Here;
  if (force <
    here.SurfaceStrength * std::sqrt(1.0 + here.Friction * here.Friction) + here.Viscosity)
  {
    motion.Way = way;
  }
}

void Follower::Learn(const Vector3& firstWay, const Vector3& way, bool isJudged) noexcept
{
  if (isJudged)
  {
    const double gain = Dot(firstWay, way) / Dot(firstWay, firstWay);
    this->State.Gain += LearnedShare * (std::clamp(gain, LeastGain, MostGain) - this->State.Gain);
  }
  else if (!this->State.IsHeld)
  {
    this->State.Gain = 1.0;
  }
}

void Follower::Creep(const Motion& motion, const Vector3& tip) noexcept
{
  Spot& here = this->State.Here;
  const double voxels = this->Field.GetVoxelsPerMeter() * Norm(motion.Way);
  this->State.Stray += std::max(voxels, LeastStray);
  this->Proxy = motion.IsFree ? tip : this->Proxy + motion.Way;
  here.Value += here.Slope * Dot(motion.Way, here.Normal);
  if (motion.IsFree)
  {
    this->State.Spring.Relax(here.Stiffness);
  }
}

} // namespace VolumeHaptics
