// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/ServoLoop.h"

#include "Core/Servo/ServoClock.h"

namespace VolumeHaptics
{
namespace
{

constexpr double NanosecondsPerSecond = 1e9;
/** 16 s at 1 kHz, should the recorder be kept from draining; every start has to clear it. */
constexpr std::size_t TraceCapacity = 1 << 14;
/** More than any method needs of the stack (bytes); the rest of it is not locked. */
constexpr std::size_t StackSize = 1 << 18;
/** The rate is averaged over at least this long (ns). */
constexpr std::int64_t RateWindow = 100000000;

} // namespace

ServoLoop::ServoLoop(DeviceBackend& backend, double rate)
  : Backend(backend)
  , Period(static_cast<std::int64_t>(NanosecondsPerSecond / rate + 0.5))
  , Trace(TraceCapacity)
{
}

ServoLoop::~ServoLoop() = default;

void ServoLoop::AskForRealTime(MemoryLock& lock) noexcept
{
  const auto answer = [](bool granted)
  { return granted ? Privilege::Granted : Privilege::Refused; };
  // The largest last: a user's limit often allows the others.
  const bool own = lock.Add(this, sizeof(*this));
  const bool stack = lock.AddStack(StackSize);
  const bool trace = lock.Add(this->Trace.GetMemory(), this->Trace.GetMemorySize());
  this->LockedMemory.store(answer(own && stack && trace));
  this->RealTimePriority.store(answer(ServoClock::RaisePriority()));
}

void ServoLoop::FollowModel() noexcept
{
  const PublishedModel* const next = this->Models.GetLatest();
  if (next == this->Current)
  {
    return;
  }
  const HapticModel* const before = this->Current ? this->Current->Model.get() : nullptr;
  const HapticModel* const after = next->Model.get();
  if (before && after)
  {
    CarryState(*before, *after, this->State);
  }
  else
  {
    this->State.Enabled = false;
  }
  this->Current = next;
  this->Models.Acknowledge(next->Generation);
}

void ServoLoop::FollowCommands() noexcept
{
  // First: what was ordered before a release is then seen with it.
  const bool wasHeld = this->Servo.IsHeld();
  // A fade that has begun goes on to zero: what is felt begins anew after it.
  const bool fades = wasHeld && !this->AtRest.load(std::memory_order_relaxed);
  this->Servo.SetHeld(this->HoldWanted.load(std::memory_order_acquire) || fades);
  if (wasHeld && !this->Servo.IsHeld())
  {
    // The hand went on while it felt nothing: a spring from where it was before would push it back.
    this->State.Enabled = false;
    this->Safety.RestartRamp();
  }
  const std::uint64_t command = this->ArmCommand.load(std::memory_order_acquire);
  if (command != this->ArmCommandSeen)
  {
    const bool isOneOrder = (command >> 2) - (this->ArmCommandSeen >> 2) == 1;
    this->ArmCommandSeen = command;
    const auto order = static_cast<ArmOrder>(command & 3);
    // Several orders at once may have a Disarm among them, of which the last one says nothing.
    const Vector3& last = this->Snapshot.Command;
    const bool flows =
      isOneOrder && this->Safety.IsArmed() && !this->Servo.IsFadingOut() && Dot(last, last) > 0.0;
    if (order == ArmOrder::FadeOut)
    {
      this->Servo.FadeOut();
    }
    else
    {
      this->Servo.Recover();
      this->IsUnattended = false;
    }
    if (order == ArmOrder::Arm && !flows)
    {
      // Re-entry after a fault starts from the tip, without force.
      this->State.Enabled = this->State.Enabled && this->Safety.GetFault() == SafetyFault::None;
      this->Safety.Arm();
    }
    else if (order == ArmOrder::Disarm)
    {
      this->Safety.Disarm();
    }
  }
  if (this->ResetRequested.exchange(false, std::memory_order_acq_rel))
  {
    this->TickCost.Reset();
    this->WakeLatency.Reset();
    this->MissedTicks.store(0, std::memory_order_relaxed);
    this->UnfinishedTicks.store(0, std::memory_order_relaxed);
    this->AbsentTicks.store(0, std::memory_order_relaxed);
    this->StatisticsStart = 0;
  }
  this->Limits.Update();
}

void ServoLoop::Attend() noexcept
{
  this->AttendedAt.store(ServoClock::Now(), std::memory_order_release);
}

void ServoLoop::FollowAttention(std::int64_t now) noexcept
{
  const double most = this->Limits.Read().AttentionTime;
  const std::int64_t silence = now - this->AttendedAt.load(std::memory_order_acquire);
  if (most > 0.0 && static_cast<double>(silence) > most * NanosecondsPerSecond &&
    this->Safety.IsArmed() && this->Safety.GetFault() == SafetyFault::None && !this->Servo.IsHeld())
  {
    // Who comes back meanwhile does not stop the fade: a hand has to be told before it is held
    // again.
    this->IsUnattended = true;
    this->Servo.FadeOut();
  }
}

void ServoLoop::TickOnce(std::int64_t start, double elapsed) noexcept
{
  const double period = static_cast<double>(this->Period) / NanosecondsPerSecond;
  ServoSnapshot& s = this->Snapshot;
  DeviceSample sample;
  sample.Tip = s.Record.Tip;
  s.Device = this->Backend.Read(period, sample);
  s.Buttons = sample.Buttons;
  s.Turn = sample.Turn;
  if (s.Device == DeviceState::NotReady)
  {
    // Whoever arms has to see that the device can be felt: it does not begin by itself.
    this->Safety.Disarm();
  }
  if (elapsed > this->Limits.Read().WatchdogTime)
  {
    // The loop stood still, and the hand did not: start from the tip.
    this->State.Enabled = false;
  }
  if (sample.Begins || (sample.Fresh && !this->HasSample))
  {
    // Not on the way from where no hand has been.
    this->State.Enabled = false;
  }
  this->HasSample = this->HasSample || sample.Fresh;
  s.Before = this->State;
  const HapticModel* const model = this->Current->Model.get();
  if (model)
  {
    this->Servo.Tick(*model, this->State, sample.Tip, period, s.Record,
      this->Fitter.FindResult(*model, this->State.Local));
    this->Fitter.Send(*model, this->State.Local);
    if (s.Record.IsUnfinished)
    {
      this->UnfinishedTicks.fetch_add(1, std::memory_order_relaxed);
    }
  }
  else
  {
    s.Record = TickRecord{};
    s.Record.Tip = s.Record.Proxy = sample.Tip;
    this->State.Enabled = false;
    this->Servo.Rest(period);
  }
  s.Residency = this->Servo.GetShare();
  s.Awaiting = this->Servo.IsAwaiting();
  if (s.Awaiting)
  {
    this->AbsentTicks.fetch_add(1, std::memory_order_relaxed);
  }

  SafetyInput input;
  input.Force = s.Record.Force;
  input.Stiffness = s.Record.Stiffness;
  input.Stretch = Norm(s.Record.Proxy - s.Record.Tip);
  // Where the data are missing, the force is that of an earlier tick.
  input.Drag = model && !s.Awaiting ? FindDrag(*model, s.Before.PreviousTip, s.Record) : Vector3{};
  input.Tip = sample.Tip;
  input.Residency = s.Residency;
  input.Period = period;
  input.Elapsed = elapsed;
  input.Fresh = sample.Fresh;
  // What Write found counts from the next tick on.
  input.Lost = s.Device == DeviceState::Lost || this->WriteLost;
  const bool retreated = this->Safety.IsRetreating();
  s.Command = this->Safety.Apply(input, this->Limits.Read());
  // Not before the command is there, too: it may follow late.
  if (this->Servo.IsFadedOut() && Dot(s.Command, s.Command) == 0.0)
  {
    this->IsUnattended ? this->Safety.Trip(SafetyFault::Unattended) : this->Safety.Disarm();
    this->IsUnattended = false;
    this->Servo.Recover();
  }
  this->WriteLost = this->Backend.Write(s.Command) == DeviceState::Lost;
  const bool isAtRest = this->Servo.IsHeld() && Dot(s.Command, s.Command) == 0.0;
  if (isAtRest)
  {
    // If the device is armed during the hold, the force must not begin with the rest of a fade.
    this->Servo.DropShare();
  }
  this->AtRest.store(isAtRest, std::memory_order_release);
  if (this->WriteLost)
  {
    s.Device = DeviceState::Lost;
  }
  if ((retreated || this->Safety.IsRetreating()) && Dot(s.Command, s.Command) == 0.0)
  {
    // It is not known where the hand went meanwhile. Not while force is left: it would end in a
    // step.
    this->State.Enabled = false;
  }

  s.Time = static_cast<double>(start) / NanosecondsPerSecond;
  s.Tick = this->TickCount.load(std::memory_order_relaxed);
  s.Generation = this->Current->Generation;
  s.Armed = this->Safety.IsArmed();
  s.Stale = this->Safety.IsStale();
  s.Fault = this->Safety.GetFault();
  this->Latest.Write(s);
  this->WrittenGeneration.store(s.Generation, std::memory_order_release);
  if (this->Recording.load(std::memory_order_acquire))
  {
    this->Trace.Push(s);
  }
  this->TickCount.store(s.Tick + 1, std::memory_order_relaxed);
}

void ServoLoop::CountTime(std::int64_t planned, std::int64_t woken, std::int64_t done) noexcept
{
  this->WakeLatency.Add(woken - planned);
  this->TickCost.Add(done - woken);
  const std::uint64_t ticks = this->TickCount.load(std::memory_order_relaxed);
  if (this->StatisticsStart == 0)
  {
    this->StatisticsStart = done;
    this->StatisticsTicks = ticks;
  }
  const std::int64_t time = done - this->StatisticsStart;
  if (time >= RateWindow)
  {
    this->TickRate.store(static_cast<double>(ticks - this->StatisticsTicks) * NanosecondsPerSecond /
        static_cast<double>(time),
      std::memory_order_relaxed);
  }
}

void ServoLoop::Run() noexcept
{
  ServoClock::BlockSignals();
  MemoryLock lock; // until the loop ends
  this->AskForRealTime(lock);
  const std::int64_t begin = ServoClock::Now();
  std::int64_t planned = begin;
  std::int64_t last = begin - this->Period;
  while (!this->StopRequested.load(std::memory_order_acquire))
  {
    const std::int64_t woken = ServoClock::Now();
    this->FollowModel();
    this->FollowCommands();
    this->FollowAttention(woken);
    this->TickOnce(woken - begin, static_cast<double>(woken - last) / NanosecondsPerSecond);
    const std::int64_t done = ServoClock::Now();
    this->CountTime(planned, woken, done);
    last = woken;

    planned += this->Period;
    if (done > planned)
    {
      // Too late for the next tick: go on in step with the clock instead of catching up in a burst.
      const std::int64_t missed = (done - planned) / this->Period + 1;
      this->MissedTicks.store(
        this->MissedTicks.load(std::memory_order_relaxed) + static_cast<std::uint64_t>(missed),
        std::memory_order_relaxed);
      planned += missed * this->Period;
    }
    ServoClock::SleepUntil(planned);
  }
  this->Backend.Write({});
}

} // namespace VolumeHaptics
