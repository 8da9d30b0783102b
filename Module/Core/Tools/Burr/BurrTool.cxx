// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Burr/BurrTool.h"

#include "Core/Tools/Burr/BakedBurr.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Limit of the steps in a tick, and limit of the trials for a step. Each trial is half as long as
 * the previous one.
 */
constexpr int MostCarvingSteps = 8;
constexpr int MostTries = 6;
/** A step shorter than this length (voxels) can't be felt. */
constexpr double ShortestStep = 1.0 / 128.0;
/** BurrState::Room grows in steps of this length (voxels), up to a voxel. */
constexpr double RoomStep = 1.0 / 16.0;
/** The longest tick (s). */
constexpr double LongestTick = 0.1;
/** A stroke ends when nothing was removed for this time (s). */
constexpr double StrokeEnd = 0.5;
/** Limit of the energy (J) that the vibration may give back. */
constexpr double MostGivenBack = 1e-3;

/** Returns the tool of a model, which must be a burr. */
const BakedBurr& GetBurr(const HapticModel& model) noexcept
{
  return static_cast<const BakedBurr&>(*model.Baked->Tool);
}

/**
 * Returns a wave from -1 to 1 that consists of parabolas and is nearly a sine. Its mean is zero.
 */
double Wave(double phase) noexcept
{
  const double x = 2.0 * phase - 1.0;
  return -4.0 * x * (1.0 - std::abs(x));
}

/** The removal of tissue in one tick. */
class Removing
{
public:
  Removing(double radius, TissueRemoval& removal, BurrState& state, SphereCarver& carver,
    BurrRecord& record) noexcept
    : Radius(radius)
    , Removal(removal)
    , State(state)
    , Carver(carver)
    , Record(record)
  {
  }

  /**
   * Removes tissue towards `goal` as far as the energy suffices. First adds `earned` (J) to the
   * energy.
   */
  void Advance(const Vector3& goal, double earned) noexcept
  {
    BurrState& s = this->State;
    s.Unspent += earned;
    if (s.Part > 0 && !this->GoOn())
    {
      return;
    }
    for (int i = 0; i < MostCarvingSteps && this->HasTime(); ++i)
    {
      const Vector3 lag = goal - s.Carved;
      const double distance = Norm(lag);
      const bool isWidened = s.Room > 0.0 && distance < ShortestStep * this->Carver.GetVoxel();
      if (distance == 0.0 || isWidened)
      {
        this->Widen(earned);
        return;
      }
      s.Room = 0.0;
      const double most = 0.25 * this->Carver.GetVoxel();
      const double longest = std::min(distance, s.Shorter > 0.0 ? std::min(s.Shorter, most) : most);
      const double slope = s.LastWay > 0.0 ? s.LastCost / s.LastWay : 0.0;
      const bool isPaid = slope * longest <= s.Unspent;
      // Step slightly less than the energy pays for, because the cost varies from step to step.
      constexpr double careful = 0.8;
      const double way = isPaid ? longest : careful * s.Unspent / slope;
      if (!isPaid && way < std::min(longest, ShortestStep * this->Carver.GetVoxel()))
      {
        // Save the energy, because so little tissue is not worth the time of a trial.
        return;
      }
      if (!this->Step(goal, lag, distance, way) || !isPaid)
      {
        return;
      }
    }
    this->Record.IsUnfinished = true;
  }

private:
  bool HasTime() const noexcept { return this->Record.Work < MostBurrWork; }

  /** Returns the cost of a sphere, or of its next part. */
  CarvingCost Try(const Vector3& next) noexcept
  {
    const BurrState& s = this->State;
    const CarvingPart part{ s.Part, MostBurrWork - this->Record.Work };
    const Vector3* const from = s.IsRemoved && s.Room == 0.0 ? &s.Carved : nullptr;
    const CarvingCost cost =
      this->Carver.Try(this->Removal, next, this->Radius + s.Room, from, part);
    this->Record.Work += cost.Work;
    return cost;
  }

  /** Removes another part of a sphere. Returns false if the tick can do no more work. */
  bool GoOn() noexcept
  {
    BurrState& s = this->State;
    const CarvingCost cost = this->Try(s.Next);
    if (cost.IsUsedUp)
    {
      this->EndUsedUp();
      return false;
    }
    if (cost.Energy > s.Unspent)
    {
      // The energy may suffice for a shorter step, or for a step to the head's present position.
      // The tissue that was removed already is not restored.
      s.Part = 0;
      s.LastCost += cost.Energy;
      if (!(cost.Energy < HUGE_VAL))
      {
        // The first part was paid for, so without a limit the next step would be as long as this
        // one.
        const double half = 0.5 * Norm(s.Next - s.Carved);
        s.Shorter = half > ShortestStep * this->Carver.GetVoxel() ? half : 0.0;
      }
      this->Save();
      return false;
    }
    this->Apply(s.Next, 0.0, cost);
    this->Record.IsUnfinished = s.Part > 0;
    return s.Part == 0;
  }

  /** Removes tissue between the samples that still touches the head, by a larger sphere. */
  void Widen(double earned) noexcept
  {
    BurrState& s = this->State;
    const double before = s.Room;
    s.Room += RoomStep * this->Carver.GetVoxel();
    if (s.Room > this->Carver.GetVoxel())
    {
      // There is no tissue for which the energy could be used.
      s.Room = before;
      s.Unspent = std::min(s.Unspent, earned);
      return;
    }
    const CarvingCost cost = this->Try(s.Carved);
    if (cost.IsUsedUp)
    {
      this->EndUsedUp();
    }
    else if (cost.Energy <= s.Unspent)
    {
      s.Unspent = std::min(s.Unspent, std::max(earned, cost.Energy));
      this->Apply(s.Carved, 0.0, cost);
      this->Record.IsUnfinished = s.Part > 0;
    }
    else
    {
      s.Room = before;
      s.Unspent = cost.Energy < HUGE_VAL ? s.Unspent : 0.0;
    }
  }

  void EndUsedUp() noexcept
  {
    this->Removal.SetUsedUp(true);
    this->State.Unspent = 0.0;
    this->State.Part = 0;
  }

  /** Keeps unspent energy for the next ticks, at most the cost of the step that failed. */
  void Save() noexcept
  {
    BurrState& s = this->State;
    s.Unspent = std::min(s.Unspent, s.LastCost);
    if (!(s.LastCost < HUGE_VAL))
    {
      // This tissue can't be removed, so its cost does not predict the cost of the next step.
      s.Unspent = s.LastCost = s.LastWay = 0.0;
    }
  }

  /**
   * Makes a step or, if the energy does not suffice, a shorter one. Returns false if it does not
   * suffice even for a shorter step, or if the step takes more than one tick.
   */
  bool Step(const Vector3& goal, const Vector3& lag, double distance, double longest) noexcept
  {
    BurrState& s = this->State;
    double way = longest;
    for (int i = 0; i < MostTries && this->HasTime(); ++i, way *= 0.5)
    {
      const Vector3 next = way == distance ? goal : s.Carved + (way / distance) * lag;
      const CarvingCost cost = this->Try(next);
      if (cost.IsUsedUp)
      {
        this->EndUsedUp();
        return false;
      }
      if (cost.Energy <= s.Unspent)
      {
        this->Apply(next, way, cost);
        this->Record.IsUnfinished = s.Part > 0;
        return s.Part == 0;
      }
      s.LastCost = cost.Energy;
      s.LastWay = way;
    }
    this->Save();
    return false;
  }

  /**
   * Removes the tissue of the last trial. `way` is the length of the step, or 0 if the first part
   * of the sphere was removed earlier.
   */
  void Apply(const Vector3& next, double way, const CarvingCost& cost) noexcept
  {
    BurrState& s = this->State;
    if (cost.Changes > 0)
    {
      if (!this->Removal.Journal.IsOpen())
      {
        this->Removal.Journal.Begin();
      }
      s.Idle = 0.0;
    }
    this->Carver.Carve(this->Removal);
    this->Removal.Journal.Count(cost.Volume);
    s.Unspent -= cost.Energy;
    if (s.Room == 0.0)
    {
      // Average the cost over several steps. Because fractions are whole numbers, a single step may
      // cost nothing, or more than its neighbours.
      const double kept = s.Part == 0 ? 0.9 : 1.0;
      s.LastCost = kept * s.LastCost + cost.Energy;
      s.LastWay = kept * s.LastWay + way;
    }
    s.Next = next;
    s.Part = cost.Next;
    if (s.Part == 0)
    {
      s.Carved = next;
      s.IsRemoved = true;
      s.Shorter = 0.0;
    }
    this->Record.Energy += cost.Energy;
    this->Record.RemovedVolume += cost.Volume;
  }

  const double Radius; ///< radius of the head (m)
  TissueRemoval& Removal;
  BurrState& State;
  SphereCarver& Carver;
  BurrRecord& Record;
};

/** Returns the depth (m) of the head's deepest point. */
double ComputeDepth(ShellMemory& memory) noexcept
{
  const ShellContacts& contacts = memory.GetCurrent();
  double depth = 0.0;
  for (std::size_t i = 0; i < contacts.Count; ++i)
  {
    depth = std::max(depth, contacts.List[i].Depth);
  }
  return depth;
}

void Remove(const HapticModel& model, const BurrHand& hand, BurrState& state,
  const BurrMemory& memory, BurrRecord& record) noexcept
{
  TissueRemoval& removal = *model.Baked->Removal;
  state.Idle += hand.Step;
  if (removal.Journal.IsOpen() && (!hand.IsSpinning || state.Idle > StrokeEnd))
  {
    removal.Journal.End();
  }
  const Vector3& head = record.Shell.Tool.Position;
  const double force = Norm(record.Shell.Force);
  if (hand.IsSpinning && !(hand.Step > 0.0))
  {
    return;
  }
  if (!hand.IsSpinning || !(force > 0.0))
  {
    // The burr does not spin, or nothing presses on its head.
    state.IsCarving = false;
    state.Part = 0;
    state.Unspent = hand.IsSpinning ? state.Unspent : 0.0;
    return;
  }
  const BakedBurr& burr = GetBurr(model);
  const ShellSettings& touch = burr.Description.Touch;
  const double radius = burr.Settings.Radius / model.WorldUnitsPerMeter;
  memory.Carver.SetTissue(model, { touch.Level, touch.IsBelow, &burr.SpecificEnergy });
  if (!state.IsCarving || Norm(state.Carved - head) > 2.0 * radius)
  {
    // Start where the burr does not touch anything yet.
    const double away = ComputeDepth(memory.Shell) + 0.5 * memory.Carver.GetRampWidth();
    state.IsCarving = true;
    state.IsRemoved = false;
    state.Part = 0;
    state.Carved = head + (away / force) * record.Shell.Force;
    state.LastCost = state.LastWay = state.Shorter = state.Room = 0.0;
  }
  Removing removing(radius, removal, state, memory.Carver, record);
  // In a cavity, the felt level is slightly in front of the removed sphere, so carve beyond the
  // head while the burr is pressed.
  const double beyond = 0.25 * memory.Carver.GetVoxel();
  const double speed = burr.RimSpeed / model.WorldUnitsPerMeter;
  removing.Advance(head - (beyond / force) * record.Shell.Force,
    burr.Settings.Friction * force * speed * hand.Step);
}

/** Returns the energy (J) in the spring between hand and head. */
double SpringEnergy(const ShellRecord& record, const Vector3& head, const Vector3& hand) noexcept
{
  const Vector3 lag = head - hand;
  return 0.5 * record.Stiffness * Dot(lag, lag);
}

/** Returns the force (N) of the vibration. */
Vector3 Vibrate(const HapticModel& model, const ShellSettings& settings, const BurrHand& by,
  const ShellState& before, const ShellState& after, BurrState& state,
  const ShellRecord& shell) noexcept
{
  if (!before.Enabled || before.IsCarried || !by.IsSpinning)
  {
    state.Lost = 0.0;
    return {};
  }
  const BakedBurr& burr = GetBurr(model);
  const Vector3& hand = shell.Hand.Position;
  const Vector3 moved = hand - before.Hand.Position;
  // Compute the hand's work on the spring. The part that the spring does not store is lost.
  const double work = SpringEnergy(shell, before.Tool.Position, hand) -
    SpringEnergy(shell, before.Tool.Position, before.Hand.Position);
  const double lost = before.Budget + work - after.Budget;
  state.Lost = std::min(state.Lost + lost - Dot(state.Vibration, moved), MostGivenBack);
  state.Phase += burr.Frequency * by.Step;
  state.Phase -= std::floor(state.Phase);
  const double force = Norm(shell.Force);
  // The hand is assumed to move at least this far until the next tick.
  constexpr double leastWay = 1e-5; // in m
  const double way = 2.0 * Norm(moved) + leastWay;
  const double most = std::min(burr.Settings.Vibration * force, std::max(state.Lost, 0.0) / way);
  if (!(most > 0.0))
  {
    return {};
  }
  const Vector3 direction = (1.0 / force) * shell.Force;
  const Vector3 vibration = (most * Wave(state.Phase)) * direction;
  // With this limit, the load on the pressed points is at most the strength of the strongest
  // tissue.
  const double strength = model.Baked->Materials.GetRange(2).High *
    model.Baked->Materials.GetRange(4).High / settings.ContactArea;
  const PointShell& head = *burr.Description.Points;
  const double pressed = settings.Scale * settings.Scale * head.GetArea() * shell.Contacts /
    static_cast<double>(std::max<std::size_t>(head.GetSize(), 1));
  const double bound = strength * pressed;
  return ClampNorm(shell.Force + vibration, std::max(bound, force)) - shell.Force;
}

} // namespace

void TickBurr(const HapticModel& model, const BurrHand& hand, ShellState& shell, BurrState& state,
  const BurrMemory& memory, BurrRecord& record) noexcept
{
  record = BurrRecord{};
  TissueRemoval* const removal = model.Baked->Removal.get();
  const PointShell& head = *GetBurr(model).Description.Points;
  const ShellSettings settings = ComputeShellSettings(model);
  const ShellState before = shell;
  TickShell(model, head, settings, { hand.Position, {} }, shell, memory.Shell, record.Shell);
  if (!shell.Enabled)
  {
    state = BurrState{};
    if (removal)
    {
      removal->Journal.End();
    }
    return;
  }
  BurrHand by = hand;
  by.Step = hand.Step > 0.0 ? std::min(hand.Step, LongestTick) : 0.0;
  state.Vibration = Vibrate(model, settings, by, before, shell, state, record.Shell);
  record.Force = record.Shell.Force + state.Vibration;
  if (removal)
  {
    Remove(model, by, state, memory, record);
  }
}

} // namespace VolumeHaptics
