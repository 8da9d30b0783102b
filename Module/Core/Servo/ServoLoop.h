// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The servo loop runs ticks at a fixed rate, on a separate thread.
 *
 * The loop never waits for its inputs and outputs:
 * - a model is published by swapping a pointer (ModelExchange.h);
 * - a slow thread fits the local surfaces (LocalSurfaceFitter.h);
 * - a second slow thread reads the samples around the tip into memory (SampleKeeper.h);
 * - a triple buffer passes the latest state out and, during a recording, a ring passes every state;
 * - a triple buffer passes the orders to the clock of a moving volume (DataClock.h);
 * - commands (arm, disarm, fade out, stop), limits and the time of the owner's last call are single
 *   atomics.
 *
 * The loop neither locks, allocates, throws nor logs. The servo's thread calls Run; slow threads
 * call RunFitter and RunSampleKeeper; a thread that may wait calls AskRealtimeKit; one reader calls
 * ReadState; one recorder calls Drain; the owner (the GUI thread) calls all other functions.
 */
#ifndef ServoLoop_h
#define ServoLoop_h

#include "Core/Realtime/MemoryLock.h"
#include "Core/Realtime/ServoPriority.h"
#include "Core/Realtime/TripleBuffer.h"
#include "Core/Realtime/WatchedSleep.h"
#include "Core/Safety/DeviceBackend.h"
#include "Core/Safety/ForceGate.h"
#include "Core/Safety/SafetyStage.h"
#include "Core/Safety/SignCheck.h"
#include "Core/Safety/TorqueStage.h"
#include "Core/Servo/DataClock.h"
#include "Core/Servo/HandTurn.h"
#include "Core/Servo/LocalSurfaceFitter.h"
#include "Core/Servo/LoopTiming.h"
#include "Core/Servo/ModelExchange.h"
#include "Core/Servo/ResidentServo.h"
#include "Core/Servo/SampleKeeper.h"
#include "Core/Servo/ServoTick.h"
#include "Core/Servo/TimeHistogram.h"
#include "Core/Servo/TraceRing.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"

#include <atomic>
#include <memory>

namespace VolumeHaptics
{

/** All data of one tick, for displays and recordings. */
struct ServoSnapshot
{
  TickRecord Record; ///< result of the tick, before the safety stage
  ServoState Before; ///< state before the tick; if its Enabled is false, the force is 0
  /** Whether this tick copied the tool's memory for a recording, which begins with Before. */
  bool IsKept = false;
  ModeForces Modes{};           ///< force (N) of each mode, before the safety stage
  Vector3 Command;              ///< force in N that was sent to the device
  Vector3 Torque;               ///< torque in N m that was sent to the device
  double Time = 0.0;            ///< time in s since the loop started
  std::uint64_t Tick = 0;       ///< number of the tick, from 0, without missed ticks
  std::uint64_t Generation = 0; ///< generation of the model; 0 without a model
  std::uint32_t Buttons = 0;
  Vector3 Turn; ///< angular velocity in rad/s (DeviceSample::Turn)
  /** Orientation of the stylus, which rotates a tool (DeviceSample::Orientation). */
  Quaternion Orientation;
  bool HasOrientation = false; ///< whether Orientation is valid and a unit quaternion
  bool IsOrdered = false;      ///< whether Orientation comes from ServoLoop::TurnHand
  GateState Gate = GateState::Disarmed;
  GateReason Reason = GateReason::Ordered; ///< reason why Share is below 1
  bool Stale = false;                      ///< whether the tip is older than the watchdog allows
  bool IsSoft = false;      ///< whether a wall feels softer than wanted (SafetyStage::IsSoft)
  bool Awaiting = false;    ///< whether missing data reduced the force
  double Share = 0.0;       ///< fraction of Record.Force that the gate let through
  double Residency = 1.0;   ///< opening of the gate, that is, Share without the ramp
  std::uint32_t Orders = 0; ///< number of orders before the tick (ServoLoop::GetOrders)
  DeviceState Device = DeviceState::Running;
  SignVerdict Signs;     ///< verdict of the sign check since RequireConfirmation
  DataClockReport Clock; ///< the clock's report if the volume moves

  bool IsArmed() const noexcept { return this->Gate != GateState::Disarmed; }
  GateReason GetFault() const noexcept { return ComputeFault(this->Gate, this->Reason); }
};

class ServoLoop
{
public:
  /** The back end must be open, and must outlive the loop. */
  ServoLoop(DeviceBackend& backend, double rate);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  /** Runs the loop until RequestStop(). Sends zero force before it returns. */
  void Run() noexcept;
  /**
   * Runs the slow loop of the method LocalSurface until RequestStop(). Without it, no surface is
   * found.
   */
  void RunFitter() noexcept { this->Fitter.Run(); }
  /**
   * Wakes Run() on another processor if its own processor does not wake it on time. Returns after
   * RequestStop().
   */
  void WatchSleep() noexcept { this->Sleep.Watch(); }
  /** See WatchedSleep::GetRescues. */
  std::uint64_t GetRescues() const noexcept { return this->Sleep.GetRescues(); }
  /**
   * If the kernel has refused a real-time class for Run(), requests it from RealtimeKit
   * (ServoPriority).
   */
  void AskRealtimeKit() noexcept { this->Priority.AskRealtimeKit(); }
  /**
   * Keeps the samples around the tip in memory until RequestStop(), and then unlocks them. Without
   * it, a tick may wait for the disk if the volume is mapped from a file.
   */
  void RunSampleKeeper() noexcept { this->Samples.Run(); }
  void RequestStop() noexcept
  {
    this->StopRequested.store(true, std::memory_order_release);
    this->Fitter.RequestStop();
    this->Priority.RequestStop();
    this->Sleep.RequestStop();
    this->Samples.RequestStop();
  }

  /**
   * Publishes a model for the next tick, and returns its generation. With nullptr, nothing is felt.
   */
  std::uint64_t Publish(std::shared_ptr<const HapticModel> model)
  {
    return this->Models.Publish(std::move(model));
  }
  /** Returns ModelExchange::GetTool(). Only the owner may call this. */
  std::shared_ptr<const ToolMemory> GetTool() const { return this->Models.GetTool(); }
  /** Frees the models that the loop no longer uses. */
  void Collect() { this->Models.Collect(); }
  /** Returns the generation of the model that the loop uses. */
  std::uint64_t GetAcknowledged() const noexcept { return this->Models.GetAcknowledged(); }

  /** Returns the lowest generation among the states that are not yet read or drained. */
  std::uint64_t GetWrittenGeneration() const noexcept
  {
    return this->WrittenGeneration.load(std::memory_order_acquire);
  }

  /** Lets force flow after a ramp, and clears a fault. Has no effect while force flows. */
  void Arm() noexcept
  {
    this->Attend();
    this->Command(ArmOrder::Arm);
  }
  /** Cuts the force in the next tick. */
  void Disarm() noexcept { this->Command(ArmOrder::Disarm); }
  /**
   * Returns whether the last of these orders was Arm, and no clutch delays it. The loop may not
   * have executed the order yet.
   */
  bool IsArmOrdered() const noexcept
  {
    const std::uint64_t command = this->ArmCommand.load(std::memory_order_relaxed);
    return OrderOf(command) == ArmOrder::Arm && !IsClutched(command);
  }
  /**
   * Returns the number of these orders, modulo 2^32. ServoSnapshot::Orders is the number of orders
   * that had arrived before a tick.
   */
  std::uint32_t GetOrders() const noexcept
  {
    return static_cast<std::uint32_t>(OrdersOf(this->ArmCommand.load(std::memory_order_relaxed)));
  }
  /**
   * Reduces the force to zero within ForceGate::FadeTime, then disarms. Has no effect if the last
   * order was Disarm, even if another thread gave it at the same time.
   */
  void FadeOut() noexcept { this->Command(ArmOrder::FadeOut); }

  ///@{
  /**
   * Hold() ends the force until Release(), whatever other orders are given. The force falls to zero
   * as with FadeOut(), but the loop stays armed, and AttentionTime is ignored. After Release() and
   * the end of the fade, the force rises as after Arm(), with the proxy at the tip, if the loop is
   * armed and has no fault. Only the owner may call these.
   */
  void Hold() noexcept { this->HoldWanted.store(true, std::memory_order_release); }
  void Release() noexcept
  {
    this->Attend();
    this->HoldWanted.store(false, std::memory_order_release);
  }
  /** Returns whether the loop is held and has sent zero force. */
  bool IsAtRest() const noexcept { return this->AtRest.load(std::memory_order_acquire); }
  ///@}

  ///@{
  /**
   * Sets whether the loop is clutched. From the next tick on, a clutched loop sends no force.
   * Afterwards, the force rises as after Arm() if the loop was armed before the clutch, or if the
   * last order was Arm (see the table of ForceGate.h).
   */
  void SetClutched(bool clutched) noexcept;
  bool IsClutched() const noexcept
  {
    return IsClutched(this->ArmCommand.load(std::memory_order_relaxed));
  }
  /** Returns whether the force would return after the clutch, according to the orders. */
  bool ReturnsAfterClutch() const noexcept
  {
    const std::uint64_t command = this->ArmCommand.load(std::memory_order_relaxed);
    return OrderOf(command) == ArmOrder::Arm && IsClutched(command);
  }
  ///@}

  /**
   * Reports that the owner is present. If the loop is armed and neither this nor Arm() is called
   * for SafetyLimits::AttentionTime, the force fades out as with FadeOut(), and the fault
   * Unattended follows until Arm(). With an AttentionTime of 0 there is no limit.
   */
  void Attend() noexcept;

  /**
   * Requires a check of the device's signs (SignCheck.h). From the next tick on, the volume is not
   * felt until the armed loop has confirmed that the device moves with the force. The owner must
   * call this before Arm(). `axes` and `force` (N) come from DeviceLimits.
   */
  void RequireConfirmation(unsigned axes, double force) noexcept
  {
    this->ConfirmForce.store(force, std::memory_order_relaxed);
    this->ConfirmAxes.store(axes, std::memory_order_release);
  }

  ///@{
  /**
   * Sets the orientation of the hand's tool, in the device's space, for a device that does not
   * measure one (HandTurn.h).
   */
  void TurnHand(const Quaternion& orientation) noexcept { this->Hand.Order(orientation); }
  void ForgetTurn() noexcept { this->Hand.Forget(); }
  ///@}

  /**
   * Makes a burr spin, even if its button is not pressed. It spins only while force flows: not
   * while the loop is disarmed, held or confirming, and not after a fault.
   */
  void Spin(bool on) noexcept { this->SpinOrdered.store(on, std::memory_order_relaxed); }

  void SetLimits(const SafetyLimits& limits) noexcept { this->Limits.Write(limits); }
  void SetDataClock(const DataClockOrders& orders) noexcept { this->ClockOrders.Write(orders); }

  bool ReadState() noexcept { return this->Latest.Update(); }
  const ServoSnapshot& GetState() const noexcept { return this->Latest.Read(); }

  /**
   * Orders a copy of the tool's memory (ToolMemory::Keep) and the end of a removal's snapshot. The
   * next tick that has a model executes both, as soon as both are possible, and a recording begins
   * with that tick. Must only be called after the last copy has been read.
   */
  void KeepTool() noexcept { this->KeepWanted.store(true, std::memory_order_release); }
  /**
   * Returns whether the copy is not made yet. If it returns false, the loop no longer uses the
   * snapshot.
   */
  bool IsKeepWanted() const noexcept { return this->KeepWanted.load(std::memory_order_acquire); }
  /** Cancels the order, from the next tick on. */
  void KeepNothing() noexcept { this->KeepWanted.store(false, std::memory_order_release); }
  void SetRecording(bool on) noexcept { this->Recording.store(on, std::memory_order_release); }
  bool Drain(ServoSnapshot& snapshot) noexcept { return this->Trace.Pop(snapshot); }
  std::uint64_t GetLostRecords() const noexcept { return this->Trace.GetLost(); }

  /** Returns the number of executed ticks since the start. Watchdogs use it as a heartbeat. */
  std::uint64_t GetTickCount() const noexcept
  {
    return this->TickCount.load(std::memory_order_relaxed);
  }

  ///@{
  /** Return the durations of ticks and the delays of wake-ups since the last ResetStatistics(). */
  const TimeHistogram& GetTickCost() const noexcept { return this->TickCost; }
  const TimeHistogram& GetWakeLatency() const noexcept { return this->WakeLatency; }
  /** Returns the number of ticks in which the solver used up its budget (PreciseSolver.h). */
  std::uint64_t GetUnfinishedTicks() const noexcept
  {
    return this->UnfinishedTicks.load(std::memory_order_relaxed);
  }
  /**
   * Returns the number of ticks whose force was reduced because data were missing (Residency.h).
   */
  std::uint64_t GetAbsentTicks() const noexcept
  {
    return this->AbsentTicks.load(std::memory_order_relaxed);
  }
  std::uint64_t GetMissedTicks() const noexcept
  {
    return this->MissedTicks.load(std::memory_order_relaxed);
  }
  /**
   * Returns the age of the positions from which forces are computed. It depends on how the device
   * is read and written, and not on the duration of ticks.
   */
  const LoopTiming& GetTiming() const noexcept { return this->Timing; }
  double GetTickRate() const noexcept { return this->TickRate.load(std::memory_order_relaxed); }
  void ResetStatistics() noexcept { this->ResetRequested.store(true, std::memory_order_release); }
  ///@}

  enum class Privilege : std::uint8_t
  {
    Unknown,
    Granted,
    Refused
  };
  RealTimeGrant GetRealTimePriority() const noexcept { return this->Priority.GetGrant(); }
  /**
   * Returns whether the loop's own memory is locked while it runs: this object with its buffers,
   * the loop's stack, and the tables of the models. The program's code, meshes, and the memory of
   * back ends and drivers are never locked.
   */
  Privilege GetLockedMemory() const noexcept
  {
    const Privilege own = this->LockedMemory.load();
    return own == Privilege::Granted && this->Models.IsLockRefused() ? Privilege::Refused : own;
  }
  /**
   * Returns whether the samples around the tip are locked. Returns Unknown if there are no such
   * samples, or if RunSampleKeeper() does not run.
   */
  Privilege GetLockedSamples() const noexcept
  {
    return this->Samples.GetLooks() == 0 ? Privilege::Unknown
      : this->Samples.IsLockRefused()    ? Privilege::Refused
                                         : Privilege::Granted;
  }
  /** Returns SampleKeeper::GetLooks(). */
  std::uint64_t GetLooksAtSamples() const noexcept { return this->Samples.GetLooks(); }

private:
  enum class ArmOrder : std::uint8_t
  {
    Disarm = 0,
    Arm = 1,
    FadeOut = 2
  };
  ///@{
  /**
   * ArmCommand has four parts: the last order (two bits), whether the loop is clutched (one bit),
   * the number of changes of the clutch, and the number of orders (upper half). All are in one
   * word, so that a tick reads a consistent state.
   */
  static constexpr std::uint64_t ClutchBit = 4;
  static constexpr std::uint64_t ClutchStep = 8;
  static constexpr std::uint64_t OrderStep = std::uint64_t(1) << 32;
  static ArmOrder OrderOf(std::uint64_t command) noexcept
  {
    return static_cast<ArmOrder>(command & 3);
  }
  static bool IsClutched(std::uint64_t command) noexcept { return (command & ClutchBit) != 0; }
  static std::uint64_t ClutchesOf(std::uint64_t command) noexcept
  {
    return command % OrderStep / ClutchStep;
  }
  static std::uint64_t OrdersOf(std::uint64_t command) noexcept { return command / OrderStep; }
  ///@}
  /** Sends an order, which replaces the last one. Any thread may call this. */
  void Command(ArmOrder order) noexcept
  {
    std::uint64_t last = this->ArmCommand.load(std::memory_order_relaxed);
    std::uint64_t next = 0;
    do
    {
      if (order == ArmOrder::FadeOut && OrderOf(last) == ArmOrder::Disarm)
      {
        return; // no force flows that could fade
      }
      next = ((last & ~std::uint64_t(3)) | static_cast<std::uint64_t>(order)) + OrderStep;
    } while (!this->ArmCommand.compare_exchange_weak(last, next, std::memory_order_release));
  }
  void ApplyOrders(std::uint64_t command) noexcept;
  void LockMemory(MemoryLock& lock) noexcept;
  void UpdateModel() noexcept;
  void ApplyCommands() noexcept;
  void UpdateAttention(std::int64_t now) noexcept;
  ///@{
  /**
   * TickOnce() runs a tick; the other functions are its steps, in order. `woken` is in ns of
   * ServoClock, `start` in ns since the loop started, and durations are in s.
   */
  void TickOnce(std::int64_t woken, std::int64_t start, double elapsed) noexcept;
  DeviceSample ReadDevice(std::int64_t woken, double period) noexcept;
  void UpdateDataClock(double period) noexcept;
  void PlaceProxy(const DeviceSample& sample, double elapsed) noexcept;
  bool IsSpinning(std::uint32_t buttons) const noexcept;
  bool KeepForRecording() noexcept;
  void Touch(const DeviceSample& sample, double period) noexcept;
  Vector3 Confirm(const DeviceSample& sample, double elapsed) noexcept;
  void SendForce(const DeviceSample& sample, double period, double elapsed) noexcept;
  void Report(std::int64_t start) noexcept;
  ///@}
  void CountTime(std::int64_t planned, std::int64_t woken, std::int64_t done) noexcept;

  DeviceBackend& Backend;
  const std::int64_t Period; // time between ticks (ns)

  ModelExchange Models;
  LocalSurfaceFitter Fitter{ this->Models };
  SampleKeeper Samples{ this->Models };
  std::atomic<std::uint64_t> WrittenGeneration{ 0 };

  std::atomic<bool> StopRequested{ false };
  std::atomic<bool> Recording{ false };
  std::atomic<bool> KeepWanted{ false };
  std::atomic<bool> SpinOrdered{ false };
  std::atomic<bool> ResetRequested{ false };
  std::atomic<bool> HoldWanted{ false };
  std::atomic<bool> AtRest{ false };
  std::atomic<std::uint64_t> ArmCommand{ 0 }; // see ClutchBit
  std::atomic<std::int64_t> AttendedAt{ 0 };  // time (ns) of ServoClock
  LoopTiming Timing;                          // written only by the servo
  std::atomic<unsigned> ConfirmAxes{ 0 };     // from RequireConfirmation, until they are processed
  std::atomic<double> ConfirmForce{ 0.0 };
  TripleBuffer<SafetyLimits> Limits;
  TripleBuffer<DataClockOrders> ClockOrders;
  TripleBuffer<ServoSnapshot> Latest;
  TraceRing<ServoSnapshot> Trace;

  // Members that only the servo uses.
  const PublishedModel* Current = nullptr;
  ServoState State;
  bool IsModelNew = false; ///< whether the model has changed since the last tick
  /** Whether the force changed in this tick for a reason other than the tip's motion. */
  bool IsForceNew = false;
  bool IsContactNew = false; ///< whether a new model requires the proxy to restart at the tip
  DataClock Clock;
  ResidentServo Servo;
  HandTurn Hand; ///< orientation ordered by the owner
  ///@{
  /** Orientation that the device measured in the last tick. */
  Quaternion MeasuredOrientation;
  bool HasMeasured = false;
  ///@}
  bool HasSample = false; ///< whether a fresh sample has come since the start
  ForceGate Gate;
  SafetyStage Safety;
  TorqueStage Torques;
  double MotionTime = 0.0; ///< SafetyInput::MotionTime in s
  SignCheck Signs;
  unsigned SignAxes = 0; ///< axes whose signs must be confirmed
  ServoSnapshot Snapshot;
  std::uint64_t ArmCommandSeen = 0;
  bool WriteLost = false;
  std::int64_t StatisticsStart = 0;
  std::uint64_t StatisticsTicks = 0;

  TimeHistogram TickCost;
  TimeHistogram WakeLatency;
  std::atomic<std::uint64_t> TickCount{ 0 };
  std::atomic<std::uint64_t> MissedTicks{ 0 };
  std::atomic<std::uint64_t> UnfinishedTicks{ 0 };
  std::atomic<std::uint64_t> AbsentTicks{ 0 };
  std::atomic<double> TickRate{ 0.0 };
  ServoPriority Priority;
  WatchedSleep Sleep;
  std::atomic<Privilege> LockedMemory{ Privilege::Unknown };
};

} // namespace VolumeHaptics

#endif
