// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/ServoLoop.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Time (s) whose ticks fit into the ring, and the ring's least number of ticks. The ring's reader
 * polls every 5 ms. A larger ring would need more time and locked memory at every start; by
 * default, a user may lock 8 MiB.
 */
constexpr double LongestWait = 0.4;
constexpr double LeastTicks = 1024.0;
/**
 * Size (bytes) of the part of the stack that is locked. No method needs more.
 */
constexpr std::size_t StackSize = 1 << 18;
/**
 * Longest distance (m) by which a new model moves the proxy. If the distance is longer, the proxy
 * restarts at the tip.
 */
constexpr double FarthestCarry = 3e-3;
/**
 * Largest change of the force by a new model, as a fraction of the maximum force, and the time (s)
 * within which the slew limit must allow this change. After a larger change, the force restarts at
 * zero.
 */
constexpr double LargestJump = 0.25;
constexpr double JumpTime = 0.05;
/** Shortest time (ns) over which the rate is averaged. */
constexpr std::int64_t RateSpan = 100000000;

} // namespace

ServoLoop::ServoLoop(DeviceBackend& backend, double rate)
  : Backend(backend)
  , Period(static_cast<std::int64_t>(ServoClock::NanosecondsPerSecond / rate + 0.5))
  , Timing(backend.GetLimits().LeastMotion)
  , Trace(static_cast<std::size_t>(std::max(LeastTicks, LongestWait * rate)))
  , Sleep(this->Period)
{
}

ServoLoop::~ServoLoop() = default;

void ServoLoop::LockMemory(MemoryLock& lock) noexcept
{
  // Lock the largest part last, because a user's limit often allows only the smaller ones.
  const bool own = lock.Add(this, sizeof(*this));
  const bool stack = lock.AddStack(StackSize);
  const bool trace = lock.Add(this->Trace.GetMemory(), this->Trace.GetMemorySize());
  this->LockedMemory.store(own && stack && trace ? Privilege::Granted : Privilege::Refused);
}

void ServoLoop::UpdateModel() noexcept
{
  const PublishedModel* const next = this->Models.GetLatest();
  if (next == this->Current)
  {
    return;
  }
  const HapticModel* const before = this->Current ? this->Current->Model.get() : nullptr;
  const HapticModel* const after = next->Model.get();
  const Vector3 proxy = this->State.Proxy;
  if (before && after)
  {
    CarryState(*before, *after, this->State, next->Tool.get());
  }
  this->IsModelNew = true;
  this->IsContactNew = !before || !after || Norm(this->State.Proxy - proxy) > FarthestCarry;
  this->Current = next;
  this->Models.Acknowledge(next->Generation);
}

void ServoLoop::SetClutched(bool clutched) noexcept
{
  this->Attend();
  std::uint64_t last = this->ArmCommand.load(std::memory_order_relaxed);
  std::uint64_t next = 0;
  do
  {
    if (IsClutched(last) == clutched)
    {
      return;
    }
    // The number of changes of the clutch is stored in the bits below the number of orders, and
    // wraps around there.
    const std::uint64_t changes = (last + ClutchStep) % OrderStep & ~(ClutchStep - 1);
    next = OrdersOf(last) * OrderStep | changes | (clutched ? ClutchBit : 0) |
      static_cast<std::uint64_t>(OrderOf(last));
  } while (!this->ArmCommand.compare_exchange_weak(last, next, std::memory_order_release));
}

void ServoLoop::ApplyOrders(std::uint64_t command) noexcept
{
  const std::uint64_t seen = std::exchange(this->ArmCommandSeen, command);
  // If several orders came at once, only the last one is known, and an earlier one may have been
  // Disarm.
  const auto orders = static_cast<std::uint32_t>(OrdersOf(command) - OrdersOf(seen));
  bool isArmed = false;
  if (orders != 0)
  {
    switch (OrderOf(command))
    {
      case ArmOrder::Disarm:
        this->Gate.Disarm();
        break;
      case ArmOrder::Arm:
        isArmed = this->Gate.Arm(orders == 1);
        break;
      case ArmOrder::FadeOut:
        this->Gate.FadeOut();
        break;
    }
  }
  // Handle the clutch after the orders: the gate stores an Arm given while clutched, and carries it
  // out on release. Set the clutch first, so that a clutch pressed and released between two ticks
  // still ends the force.
  if (ClutchesOf(command) != ClutchesOf(seen))
  {
    this->Gate.SetClutched(true);
    isArmed = this->Gate.SetClutched(IsClutched(command)) || isArmed;
  }
  if (isArmed)
  {
    this->Safety.Reset();
  }
}

void ServoLoop::ApplyCommands() noexcept
{
  // Read this first, because the orders before a release must take effect together with it.
  this->Gate.SetHeld(this->HoldWanted.load(std::memory_order_acquire));
  this->ApplyOrders(this->ArmCommand.load(std::memory_order_acquire));
  // Read this after the orders, because a confirmation is required before Arm().
  if (const unsigned axes = this->ConfirmAxes.exchange(0, std::memory_order_acq_rel))
  {
    this->SignAxes = axes;
    this->Signs.Begin(axes, this->ConfirmForce.load(std::memory_order_relaxed));
    this->Gate.SetUnconfirmed(true);
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
  this->ClockOrders.Update();
}

void ServoLoop::Attend() noexcept
{
  this->AttendedAt.store(ServoClock::Now(), std::memory_order_release);
}

void ServoLoop::UpdateAttention(std::int64_t now) noexcept
{
  const double most = this->Limits.Read().AttentionTime;
  const std::int64_t silence = now - this->AttendedAt.load(std::memory_order_acquire);
  if (most > 0.0 && static_cast<double>(silence) > most * ServoClock::NanosecondsPerSecond)
  {
    this->Gate.ReportSilence();
  }
}

void ServoLoop::TickOnce(std::int64_t woken, std::int64_t start, double elapsed) noexcept
{
  const double period = static_cast<double>(this->Period) / ServoClock::NanosecondsPerSecond;
  const DeviceSample sample = this->ReadDevice(woken, period);
  this->UpdateDataClock(period);
  this->PlaceProxy(sample, elapsed);
  this->Touch(sample, period);
  this->SendForce(sample, period, elapsed);
  this->Report(start);
}

DeviceSample ServoLoop::ReadDevice(std::int64_t woken, double period) noexcept
{
  ServoSnapshot& s = this->Snapshot;
  DeviceSample sample;
  sample.Tip = s.Record.Tip;
  sample.Orientation = this->MeasuredOrientation;
  sample.HasOrientation = this->HasMeasured;
  s.Device = this->Backend.Read(period, sample);
  s.Buttons = sample.Buttons;
  s.Turn = sample.Turn;
  this->HasMeasured = sample.HasOrientation && MakeUnit(sample.Orientation);
  this->MeasuredOrientation = this->HasMeasured ? sample.Orientation : Quaternion{};
  sample.Orientation = this->MeasuredOrientation;
  sample.HasOrientation = this->Hand.Update(period, sample.Orientation, this->HasMeasured);
  s.Orientation = sample.Orientation;
  s.HasOrientation = sample.HasOrientation;
  s.IsOrdered = s.HasOrientation && !this->HasMeasured;
  sample.Time = sample.Time == 0 ? woken : sample.Time;
  this->MotionTime = this->Timing.RecordSample(sample, woken);
  if (s.Device == DeviceState::NotReady)
  {
    // Force never starts without an order, so the user must arm again when the device is ready.
    this->Gate.ReportNotReady();
  }
  return sample;
}

void ServoLoop::UpdateDataClock(double period) noexcept
{
  const HapticModel* const model = this->Current->Model.get();
  if (model && model->Baked->IsMoving())
  {
    DataClockOrders orders = this->ClockOrders.Read();
    // A surface must not move past a hand that can't feel it.
    orders.Plays = orders.Plays && !this->Servo.LacksData();
    const DataClock::Leap leap = this->Clock.Update(*model->Baked, orders, period, this->State);
    this->IsModelNew = this->IsModelNew || leap != DataClock::Leap::None;
    this->IsContactNew = this->IsContactNew || leap == DataClock::Leap::Away;
  }
  else
  {
    this->Clock.Rest();
  }
  this->Snapshot.Clock = this->Clock.GetReport();
}

void ServoLoop::PlaceProxy(const DeviceSample& sample, double elapsed) noexcept
{
  // The proxy restarts at the tip, without a force, for one of the following four reasons. Tick()
  // and ResidentServo do the same after a tip that is not finite, and after missing data.
  const bool isContactNew = std::exchange(this->IsContactNew, false);
  // The loop was blocked for longer than the watchdog's time, while the hand moved on.
  const bool stood = elapsed > this->Limits.Read().WatchdogTime;
  // The stylus was just picked up, so the proxy must not remain at a tip that no hand held.
  const bool isTakenUp = sample.Begins || (sample.Fresh && !this->HasSample);
  // The hand moved while the gate let no force through (see the table of ForceGate.h).
  const bool isGateNew = this->Gate.DrainRestart();
  if (isContactNew || stood || isTakenUp || isGateNew)
  {
    this->State.Enabled = false;
    this->IsForceNew = true;
  }
  this->HasSample = this->HasSample || sample.Fresh;
  this->State.Orientation = this->Snapshot.Orientation;
  this->State.HasOrientation = sample.HasOrientation;
  this->State.IsSpinning = this->IsSpinning(sample.Buttons);
  this->Snapshot.Before = this->State;
  this->Snapshot.IsKept = this->KeepForRecording();
}

bool ServoLoop::IsSpinning(std::uint32_t buttons) const noexcept
{
  const HapticModel* const model = this->Current->Model.get();
  const GateState gate = this->Gate.GetState();
  const bool isFelt =
    gate == GateState::Ramping || gate == GateState::Armed || gate == GateState::Fading;
  const BakedTool* const tool = model && isFelt ? model->Baked->Tool.get() : nullptr;
  return tool && tool->Spins(buttons, this->SpinOrdered.load(std::memory_order_relaxed));
}

bool ServoLoop::KeepForRecording() noexcept
{
  const HapticModel* const model = this->Current->Model.get();
  if (!model || !this->KeepWanted.load(std::memory_order_acquire))
  {
    return false;
  }
  TissueRemoval* const removal = model->Baked->Removal.get();
  const bool isKept = !removal || removal->TakeSnapshot();
  if (!isKept && !removal->IsSnapshotLate())
  {
    return false; // the next tick tries again
  }
  if (isKept && this->Current->Tool)
  {
    this->Current->Tool->Keep();
  }
  // Write this last, because another thread may use the snapshot from then on.
  this->KeepWanted.store(false, std::memory_order_release);
  return isKept;
}

void ServoLoop::Touch(const DeviceSample& sample, double period) noexcept
{
  ServoSnapshot& s = this->Snapshot;
  const Vector3 before = s.Record.Force;
  // If the tick has served a request, the hand now feels a changed volume.
  this->IsModelNew = this->IsModelNew || s.Record.IsServed;
  if (const HapticModel* const model = this->Current->Model.get())
  {
    this->Servo.Tick(*model, this->State, sample.Tip, period, s.Record,
      this->Fitter.PollResult(*model, this->State.Local), this->Gate, this->Current->Tool.get());
    s.Modes = ComputeModeForces(*model, this->State);
    this->Fitter.Send(*model, this->State.Local);
    this->Samples.Update(s.Record.Tip, s.Record.Proxy);
    if (s.Record.IsUnfinished)
    {
      this->UnfinishedTicks.fetch_add(1, std::memory_order_relaxed);
    }
  }
  else
  {
    s.Record = TickRecord{};
    s.Modes = {};
    s.Record.Tip = s.Record.Proxy = sample.Tip;
    this->Servo.Rest(period, this->Gate);
  }
  this->IsForceNew = this->IsForceNew || s.Record.IsServed;
  if (std::exchange(this->IsModelNew, false))
  {
    this->IsForceNew = true;
    const SafetyLimits& limits = this->Limits.Read();
    const double most = limits.MaximumForce;
    const double jump = Norm(ClampNorm(s.Record.Force, most) - ClampNorm(before, most));
    if (jump > std::min(LargestJump * most, limits.MaximumForceRate * JumpTime))
    {
      this->Gate.ReportJump();
    }
  }
  s.Residency = this->Gate.GetOpening();
  s.Awaiting = this->Servo.IsAwaiting();
  if (s.Awaiting)
  {
    this->AbsentTicks.fetch_add(1, std::memory_order_relaxed);
  }
}

/** Returns the push of the sign check while the gate waits for the verdict. */
Vector3 ServoLoop::Confirm(const DeviceSample& sample, double elapsed) noexcept
{
  const bool isUnderWay =
    this->Gate.GetState() == GateState::Confirming && this->Gate.GetOpening() == 1.0;
  if (!isUnderWay || sample.Begins)
  {
    this->Signs.Interrupt();
    return {};
  }
  if (this->Signs.GetVerdict().Result != SignResult::Pending)
  {
    // The check restarts after any verdict except Confirmed.
    this->Signs.Begin(this->SignAxes, this->ConfirmForce.load(std::memory_order_relaxed));
  }
  const Vector3 push = this->Signs.Step(sample.Tip, sample.Fresh || sample.Alive, elapsed);
  switch (this->Signs.GetVerdict().Result)
  {
    case SignResult::Pending:
      break;
    case SignResult::Confirmed:
      this->Gate.SetUnconfirmed(false);
      break;
    case SignResult::Wrong:
      this->Gate.ReportFault(GateReason::WrongSign);
      break;
    case SignResult::NoMotion:
    case SignResult::Restless:
      this->Gate.ReportFault(GateReason::Unmoved);
      break;
  }
  return push;
}

void ServoLoop::SendForce(const DeviceSample& sample, double period, double elapsed) noexcept
{
  ServoSnapshot& s = this->Snapshot;
  const HapticModel* const model = this->Current->Model.get();
  const BakedTool* const tool = model ? model->Baked->Tool.get() : nullptr;
  SafetyInput input;
  if (this->Gate.IsUnconfirmed())
  {
    input.Force = this->Confirm(sample, elapsed);
  }
  else
  {
    input.Force = s.Record.Force;
    input.Stiffness = s.Record.Stiffness;
    input.Slope = s.Record.Slope;
    input.Stretch = Norm(s.Record.Proxy - s.Record.Tip);
    input.Feedback = model ? model->Caps.Feedback : 0.0;
    const bool isHeld = s.Record.Contact != ContactState::Free;
    if (isHeld && this->Limits.Read().TransientGain > 0.0)
    {
      input.Frequency =
        ContactTransient::ComputeFrequency(s.Record.Stiffness, s.Record.SurfaceStrength);
    }
    // If data are missing, the force comes from an earlier tick.
    input.Drag = model && !s.Awaiting ? ComputeDrag(*model, s.Before, s.Record) : Vector3{};
  }
  input.Torque = s.Record.Torque;
  input.Tip = sample.Tip;
  input.Period = period;
  input.Elapsed = elapsed;
  input.Fresh = sample.Fresh;
  input.Alive = sample.Alive;
  // If data are missing, no tick was computed, so the wall did no work.
  input.WallWork = s.Awaiting ? 0.0 : s.Record.WallWork;
  input.MotionTime = this->MotionTime;
  input.RoundTrip = this->Timing.GetRoundTrip();
  input.IsNew = std::exchange(this->IsForceNew, false);
  // If Write reported that the device is lost, the loss takes effect in the next tick.
  input.Lost = s.Device == DeviceState::Lost || this->WriteLost;
  const SafetyLimits& limits = this->Limits.Read();
  s.Command = this->Safety.Apply(input, limits, this->Gate);
  s.Torque = this->Torques.Apply({ s.Record.Torque, tool ? tool->GetTurningStiffness() : 0.0,
                                   s.Orientation, sample.Fresh, period },
    limits, this->Gate);
  this->WriteLost = this->Backend.Send({ s.Command, s.Torque }) == DeviceState::Lost;
  if (sample.Taken.Of != 0)
  {
    this->Timing.RecordTaken(sample.Taken);
  }
  else if (sample.Fresh)
  {
    this->Timing.RecordTaken({ sample.Time, ServoClock::Now() });
  }
  // Store this only after the device has received the force.
  this->AtRest.store(this->Gate.IsAtRest(), std::memory_order_release);
  if (this->WriteLost)
  {
    s.Device = DeviceState::Lost;
  }
}

void ServoLoop::Report(std::int64_t start) noexcept
{
  ServoSnapshot& s = this->Snapshot;
  s.Time = static_cast<double>(start) / ServoClock::NanosecondsPerSecond;
  s.Tick = this->TickCount.load(std::memory_order_relaxed);
  s.Generation = this->Current->Generation;
  s.Gate = this->Gate.GetState();
  s.Reason = this->Gate.GetReason();
  s.Share = this->Gate.GetShare();
  s.Orders = static_cast<std::uint32_t>(OrdersOf(this->ArmCommandSeen));
  s.Stale = this->Safety.IsStale();
  s.IsSoft = this->Safety.IsSoft();
  s.Signs = this->Signs.GetVerdict();
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
  if (time >= RateSpan)
  {
    this->TickRate.store(static_cast<double>(ticks - this->StatisticsTicks) *
        ServoClock::NanosecondsPerSecond / static_cast<double>(time),
      std::memory_order_relaxed);
  }
}

void ServoLoop::Run() noexcept
{
  ServoClock::BlockSignals();
  MemoryLock lock; // locks memory until the loop ends
  this->LockMemory(lock);
  this->Priority.Raise();
  const std::int64_t begin = ServoClock::Now();
  std::int64_t planned = begin;
  std::int64_t last = begin - this->Period;
  while (!this->StopRequested.load(std::memory_order_acquire))
  {
    const std::int64_t woken = ServoClock::Now();
    this->UpdateModel();
    this->ApplyCommands();
    this->UpdateAttention(woken);
    this->TickOnce(
      woken, woken - begin, static_cast<double>(woken - last) / ServoClock::NanosecondsPerSecond);
    const std::int64_t done = ServoClock::Now();
    this->CountTime(planned, woken, done);
    last = woken;

    planned += this->Period;
    if (done > planned)
    {
      // The next tick is already late. Skip ticks, so that the loop does not catch up in a burst.
      const std::int64_t missed = (done - planned) / this->Period + 1;
      this->MissedTicks.store(
        this->MissedTicks.load(std::memory_order_relaxed) + static_cast<std::uint64_t>(missed),
        std::memory_order_relaxed);
      planned += missed * this->Period;
    }
    this->Sleep.SleepUntil(planned);
  }
  this->Backend.Send({});
}

} // namespace VolumeHaptics
