// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PreciseSolver.h"

#include "PreciseMotion.h"
#include "ServoTick.h"

namespace VolumeHaptics
{
namespace
{

/** Voxels that tip and proxy go at a time; the tip may go this share of the spring, if that is more. */
constexpr double LongestStep = 0.25;
constexpr double SpringShare = 0.02;
/** A motion this short (voxels) is not judged at its end. */
constexpr double ShortStep = 1e-3;
/** Nor is a longer one, up to this, that would leave so little to be done. */
constexpr double LongestCreep = 0.03;
constexpr double LongestRest = 2e-3;

/** Of a quotient: a way of just so many steps is not to be one step more on another machine. */
constexpr double Rounding = 1e-9;
/** Motions at one tip that may lengthen the spring. */
constexpr int MostSetbacks = 8;

/** Moves the proxy of one tick. */
class Follower
{
public:
  Follower(const HapticModel& model, const ServoState& state) noexcept
    : Field(model)
    , IsTwoSided(model.Settings.Side == SurfaceSide::Both)
    , Proxy(state.Proxy)
    , State(state.Precise)
  {
  }

  /** Takes the tip along a straight way, and the proxy after it. */
  void Follow(const Vector3& tip) noexcept
  {
    const Vector3 from = this->State.ReachedTip;
    this->Here = this->Field.Look(this->Proxy, from - this->Proxy);
    this->Refresh(Norm(from - this->Proxy));
    Vector3 at = from;
    for (double steps = 2.0; steps > 1.0;)
    {
      // Far from the proxy a longer step turns the spring no more.
      const double longest =
        std::max(LongestStep, SpringShare * this->Field.Voxels(at - this->Proxy));
      const bool isBeyond = this->Field.IsBeyond(at, tip) && this->Field.IsBeyond(this->Proxy, tip);
      const Vector3 way = tip - at;
      steps = isBeyond ? 1.0 : std::ceil(this->Field.Voxels(way) / longest - Rounding);
      at = steps > 1.0 ? at + (1.0 / steps) * way : tip;
      if (!this->Settle(at))
      {
        return;
      }
    }
  }

  void Write(TickRecord& record) const noexcept
  {
    static_cast<Place&>(record) = this->Here;
    record.Proxy = this->Proxy;
    if (!Law::IsFelt(this->Here))
    {
      return;
    }
    record.Stiffness = this->State.Spring.GetEffective();
    record.Force = record.Stiffness * (this->Proxy - this->State.ReachedTip);
    record.NormalForce = this->Last.Normal;
    record.FrictionForce = this->Last.Friction;
    record.DragForce = std::min(this->Here.Viscosity, this->Last.Excess);
    if (this->Pushes && this->Last.Normal > Law::ForceEpsilon)
    {
      record.Contact = this->WentThrough
        ? ContactState::Penetrating
        : (this->Slid ? ContactState::Sliding : ContactState::Sticking);
    }
  }

  const PreciseState& GetState() const noexcept { return this->State; }
  bool IsUnfinished() const noexcept { return this->LooksAreSpent; }

private:
  /** The tissue where the proxy has been since the last tick: whatever changed there, nobody moved. */
  void Refresh(double lag) noexcept
  {
    PassiveSpring& spring = this->State.Spring;
    const double reserve = spring.Reserve;
    spring.DropReserve();
    PassOn(spring, this->Here.Stiffness, lag);
    spring.Reserve += spring.Tension > 0.0 && lag > 0.0 ? reserve : 0.0;
  }

  /** Moves the proxy until the law leaves it in place; false if the looks do not suffice. */
  bool Settle(const Vector3& tip) noexcept
  {
    const Vector3 before = this->State.ReachedTip;
    if (!Law::IsFelt(this->Here))
    {
      // All slack, but for what the hand does now: a proxy on its way to the tip brings no force along.
      this->State.Spring.Tension = 0.0;
    }
    this->State.Spring.Stretch(Norm(before - this->Proxy), Norm(tip - this->Proxy));
    this->State.ReachedTip = tip;
    bool isFirst = true;
    double lastVoxels = 0.0;
    Vector3 lastWay;
    int setbacks = 0;
    for (;;)
    {
      if (this->IsTwoSided && Dot(tip - this->Proxy, this->Here.Normal) < 0.0)
      {
        this->Here = this->Field.Look(this->Proxy, tip - this->Proxy);
      }
      Motion motion = this->Plan(tip, isFirst ? before : tip);
      isFirst = false;
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
      this->Here = end.There;
      this->State.Spring = end.Spring;
    }
  }

  /** What the law asks for, with the place where the proxy is. */
  Motion Plan(const Vector3& tip, const Vector3& tipBefore) noexcept
  {
    Motion motion;
    const Vector3 lag = tip - this->Proxy;
    this->Pushes = false;
    this->Last = Balance{};
    if (!Law::IsFelt(this->Here))
    {
      this->State.IsHeld = false;
      motion.Way = lag;
      motion.IsFree = true;
      return motion;
    }
    const double k = this->State.Spring.GetEffective();
    const SplitLag split = Law::Split(lag, this->Here.Normal);
    this->Pushes = split.Push > 0.0;
    this->Last = Law::Weigh(this->Here, k, split);
    motion.IsHeld = this->Pushes && !this->Last.IsThrough && this->Here.Slope != 0.0;
    motion.IsFree = this->Last.Normal == 0.0 && this->Here.Viscosity == 0.0;
    const bool turns = this->Here.Friction * this->Last.Normal + this->Here.Viscosity > 0.0;
    if (motion.IsFree)
    {
      motion.Way = lag;
    }
    else if (turns && this->Last.Excess > this->Here.Viscosity)
    {
      motion.Way = MoveAlong(this->Here, k, tipBefore - this->Proxy, lag);
    }
    else
    {
      motion.Way = Law::Move(this->Here, k, split, this->Last, Vector3{});
    }
    if (!motion.IsHeld)
    {
      this->State.IsHeld = false;
      return motion;
    }
    // The surface may have been left and met again on the way.
    const double inward = Dot(motion.Way, this->Here.Normal);
    if (!this->State.IsHeld || std::abs(inward) > Rounding * Norm(motion.Way))
    {
      this->State.IsHeld = true;
      this->State.Level = this->Here.Value + this->Here.Slope * inward;
      return motion;
    }
    motion.Way += this->Field.ToLevel(this->Here, k, this->State.Level, lag);
    return motion;
  }

  /** What the tick's contact will be called. */
  void Note(double voxels) noexcept
  {
    const bool moves = voxels > 0.0 && this->Pushes;
    this->WentThrough = this->WentThrough || (moves && this->Last.IsThrough);
    this->Slid = this->Slid || (moves && this->Last.Slides);
  }

  /** Makes a motion longer, if the spring stays within what the place holds. */
  void Lengthen(Motion& motion, double factor, const Vector3& tip) const noexcept
  {
    const Vector3 way = factor * motion.Way;
    const double force = this->State.Spring.GetEffective() * Norm(tip - this->Proxy - way);
    const double mu = this->Here.Friction;
    if (force < this->Here.SurfaceStrength * std::sqrt(1.0 + mu * mu) + this->Here.Viscosity)
    {
      motion.Way = way;
    }
  }

  /** A motion too short to be judged. */
  void Creep(const Motion& motion, const Vector3& tip) noexcept
  {
    this->Proxy = motion.IsFree ? tip : this->Proxy + motion.Way;
    this->Here.Value += this->Here.Slope * Dot(motion.Way, this->Here.Normal);
    if (motion.IsFree)
    {
      this->State.Spring.Relax(this->Here.Stiffness);
    }
  }

  Surroundings Field;
  const bool IsTwoSided;
  Vector3 Proxy;
  PreciseState State;
  Spot Here;
  Balance Last{};
  bool Pushes = false;
  bool WentThrough = false;
  bool Slid = false;
  bool LooksAreSpent = false;
};

} // namespace

void StepPrecise(const HapticModel& model, ServoState& state, TickRecord& record) noexcept
{
  if (!state.Enabled)
  {
    state.Proxy = record.Tip;
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = record.Tip;
  }
  Follower follower(model, state);
  follower.Follow(record.Tip);
  follower.Write(record);
  state.Precise = follower.GetState();
  record.IsUnfinished = follower.IsUnfinished();
}

} // namespace VolumeHaptics
