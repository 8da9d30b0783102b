// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Exchanges positions and forces between the servo and the thread that communicates with a device.
 *
 * Libraries for USB and HID use locks and allocate memory, so a separate thread calls them.
 * Positions and forces are exchanged through buffers with a single producer each, so that the servo
 * never waits, and the device always receives the latest force. If the servo does not renew a
 * force, the force falls to zero.
 *
 * The exchange can also be in memory that two processes share, with the device's thread in the
 * other process (Devices/Guard): it consists only of values, atomics and a file descriptor with the
 * same number in both processes.
 */
#ifndef HardwareExchange_h
#define HardwareExchange_h

#include "Core/Realtime/TripleBuffer.h"
#include "Core/Safety/DeviceBackend.h"

#include <atomic>

namespace VolumeHaptics
{

class HardwareExchange
{
public:
  /**
   * Time (s) without a new force after which the last force begins to fade, and duration (s) of the
   * fade to zero.
   */
  static constexpr double WatchdogTime = 0.03;
  static constexpr double FadeTime = 0.02;

  using Clock = std::int64_t (*)();

  /**
   * Makes an exchange. `asleep` returns the time (ns) that the computer has been asleep since it
   * was started. Null means GetTimeAsleep, whose address differs between processes.
   */
  explicit HardwareExchange(Clock asleep = nullptr);
  ~HardwareExchange();
  HardwareExchange(const HardwareExchange&) = delete;
  HardwareExchange& operator=(const HardwareExchange&) = delete;

  ///@{
  /**
   * Called by the servo. Begins is true in the first sample after the device became ready. If the
   * device was unready at any time between two calls, the next call returns NotReady even if the
   * device is ready again.
   */
  DeviceState Receive(DeviceSample& sample) noexcept;
  DeviceState Give(const Vector3& force, const Vector3& torque = {}) noexcept;
  ///@}

  ///@{
  /**
   * Quench() ends the force until the next Give(). IsAtRest() returns whether the device is at
   * rest: its thread has requested the force twice and received zero, so the first zero was sent.
   * Both may be called from any thread.
   */
  void Quench() noexcept;
  bool IsAtRest() const noexcept { return this->ZeroRounds.load(std::memory_order_acquire) > 1; }
  ///@}

  ///@{
  /** Called by the owner. Begin() resets the exchange before the device's thread starts. */
  void Begin() noexcept;
  void RequestStop() noexcept;
  DeviceCondition GetCondition() noexcept;
  void RequestHome() noexcept;
  void SetLights(int lights) noexcept { this->Lights.store(lights); }
  ///@}

  ///@{
  /**
   * Requests for the device's thread. Lights are negative if the device shows its own condition.
   */
  bool MustStop() const noexcept { return this->StopRequested.load(std::memory_order_acquire); }
  /**
   * Returns whether homing was requested since the last call. If so, sets the stage to Homing,
   * which the servo sees even if the device is ready again at once. Discards forces from before.
   */
  bool DrainHomeRequest() noexcept;
  /**
   * Sets the stage to Homing for a device that was lost and reconnected. Discards earlier homing
   * requests and sleeps.
   */
  void BeginAgain() noexcept;
  bool IsHomeRequested() const noexcept
  {
    return this->HomeRequested.load(std::memory_order_acquire);
  }
  /**
   * Discards a pending homing request that can't succeed, for example because the device is
   * unplugged. The device stays Lost, with this text.
   */
  void RefuseHomeRequest(const char* text) noexcept;
  int GetLights() const noexcept { return this->Lights.load(); }
  /**
   * Returns the force and torque to send now. They are zero unless the device is ready and the
   * servo renews them.
   */
  DeviceCommand GetCommand() noexcept;
  /** Returns the force (N) of GetCommand(), for a device without torque. */
  Vector3 GetForce() noexcept { return this->GetCommand().Force; }
  /**
   * Records that the device has this force: it was received, or equals the previous one. The servo
   * uses this to measure how old the positions are on which the forces are based (LoopTiming.h).
   */
  void RecordTaken() noexcept;
  /**
   * Returns a file descriptor that becomes readable when there is a force, a stop or a homing
   * request. ClearWake() resets it for the next event. Returns a negative number on systems without
   * such descriptors.
   */
  int GetWakeDescriptor() const noexcept { return this->Wake; }
  void ClearWake() noexcept;
  /**
   * Waits at most `time` (ms) for a force, a stop or a homing request. Then clears the descriptor.
   */
  void WaitForWake(int time) noexcept;
  ///@}

  ///@{
  /**
   * Called by the device's thread. Reports a new measurement that was made at the sample's Time, or
   * now if Time is 0. A sample with the same Time as the last one counts as Confirm(). The servo
   * receives samples only while the device is ready, so report one before the stage becomes Ready.
   * That first sample gets Begins, because the hand may have moved before.
   */
  void Report(const DeviceSample& sample) noexcept;
  /**
   * Confirms that the device is connected and that the tip is still at the last sample. Must only
   * be called after a Report() since Begin().
   */
  void Confirm() noexcept { this->Samples.Write(this->Told); }
  /**
   * Sets the condition. Too long a text is truncated. The stage Lost persists until
   * DrainHomeRequest(), BeginAgain() or Begin(), even if another stage is set, so that the device
   * does not resume by itself.
   */
  void SetCondition(DeviceStage stage, const char* text) noexcept;
  /** Sets the condition, with the device's name before the text unless the text is empty. */
  void SetCondition(DeviceStage stage, const char* name, const char* text) noexcept;
  /**
   * Returns whether the computer was asleep since the last call. Must be called once in each round.
   * After a sleep the stage becomes Lost, because the hand may have moved unnoticed.
   */
  bool HasSlept() noexcept;
  ///@}

  /** Returns the time (ns) for which the computer was suspended since it was started. */
  static std::int64_t GetTimeAsleep() noexcept;

private:
  struct TimedForce
  {
    Vector3 Force;
    Vector3 Torque;
    std::int64_t Time = 0;
    std::uint32_t TimesReady = 0; ///< value of the exchange's TimesReady that the servo saw last
    std::int64_t Of = 0;          ///< DeviceSample::Time of the last sample that the servo received
  };
  void WakeUp() noexcept;
  void SetHoming() noexcept;
  /** Updates SleptBefore. */
  void MeasureAsleep() noexcept;
  std::int64_t ReadAsleep() const noexcept
  {
    return this->Asleep != nullptr ? this->Asleep() : GetTimeAsleep();
  }

  const Clock Asleep;
  int Wake = -1;
  std::int64_t SleptBefore = 0; ///< used only by the device's thread
  /** Used only by the servo: whether it has received a sample since the device became ready. */
  bool IsUnderWay = false;
  std::uint32_t TimesReadySeen = 0; ///< used only by the servo
  std::int64_t TimeSeen = 0; ///< used only by the servo: DeviceSample::Time of the last sample
  DeviceSample Told;         ///< used only by the device's thread: the last sample
  std::atomic<std::uint32_t> TimesReady{ 0 }; ///< number of times that the device became ready
  TripleBuffer<DeviceSample> Samples;
  TripleBuffer<TimedForce> Forces;
  TripleBuffer<TakenForce> TakenForces;
  TripleBuffer<DeviceCondition> Conditions;
  std::atomic<DeviceStage> Stage{ DeviceStage::Lost };
  std::atomic<bool> Quenched{ true };
  /// Number of rounds with zero force since the last nonzero force, or since Quench(); at most 2.
  std::atomic<int> ZeroRounds{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<bool> HomeRequested{ false };
  std::atomic<int> Lights{ -1 };
};

} // namespace VolumeHaptics

#endif
