// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The exchange between the servo and the thread that talks to a device.
 *
 * Libraries for USB and HID lock and allocate, so a separate thread calls them. It passes positions
 * to the servo and receives forces from it through single-producer buffers: the servo never waits,
 * and the device always gets the latest force. A force that the servo stops renewing falls to zero.
 *
 * If the exchange is in memory that two processes share, that thread may be in the other process
 * (Devices/Guard): the exchange has values, atomics and a file descriptor of one number in both.
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
  /** After this time (s) without a new force, the last force falls to zero, over the same time. */
  static constexpr double WatchdogTime = 0.03;
  static constexpr double FadeTime = 0.02;

  using Clock = std::int64_t (*)();

  /**
   * Makes an exchange. `asleep` returns how long (ns) the computer has been asleep since it was
   * started; null stands for GetTimeAsleep, whose address differs between processes.
   */
  explicit HardwareExchange(Clock asleep = nullptr);
  ~HardwareExchange();
  HardwareExchange(const HardwareExchange&) = delete;
  HardwareExchange& operator=(const HardwareExchange&) = delete;

  ///@{
  /**
   * Called by the servo. The first sample since the device became ready has Begins set. If the
   * device was not ready for a moment between two calls, the next call still returns NotReady.
   */
  DeviceState Receive(DeviceSample& sample) noexcept;
  DeviceState Give(const Vector3& force, const Vector3& torque = {}) noexcept;
  ///@}

  ///@{
  /**
   * Ends the force until the next Give. The device is at rest once its thread has asked for the
   * force twice, since by the second time it has sent the first answer. Any thread.
   */
  void Quench() noexcept;
  bool IsAtRest() const noexcept { return this->ZeroRounds.load(std::memory_order_acquire) > 1; }
  ///@}

  ///@{
  /** Called by the owner. Begin resets the exchange, before the device's thread starts. */
  void Begin() noexcept;
  void RequestStop() noexcept;
  DeviceCondition GetCondition() noexcept;
  void RequestHome() noexcept;
  void SetLights(int lights) noexcept { this->Lights.store(lights); }
  ///@}

  ///@{
  /**
   * Requests to the device, read by the device's thread. Lights are negative if the device shows
   * its own condition.
   */
  bool MustStop() const noexcept { return this->StopRequested.load(std::memory_order_acquire); }
  /**
   * Returns whether homing was requested since the last call. If so, the device is Homing, which
   * the servo sees even if the device is ready again at once; earlier forces no longer count.
   */
  bool DrainHomeRequest() noexcept;
  /**
   * Refuses a homing request that can't help, for example because the device is unplugged: the
   * device stays Lost, with this text.
   */
  void RefuseHomeRequest(const char* text) noexcept;
  int GetLights() const noexcept { return this->Lights.load(); }
  /** Returns the order to send now: zero unless the device is ready and the servo alive. */
  DeviceCommand GetCommand() noexcept;
  /** Returns the force of the order (N), for a device without torque. */
  Vector3 GetForce() noexcept { return this->GetCommand().Force; }
  /**
   * Records that the device has this force: it took what was sent, or already held the same force.
   * From this the servo measures how old positions are in the forces (LoopTiming.h).
   */
  void RecordTaken() noexcept;
  /**
   * Returns a file descriptor that becomes readable on a force, a stop or a homing request;
   * negative if the system has no such descriptors. ClearWake resets it for the next event.
   */
  int GetWakeDescriptor() const noexcept { return this->Wake; }
  void ClearWake() noexcept;
  /**
   * Waits for a force, a stop or a homing request, or for a time (ms), and clears the descriptor.
   */
  void WaitForWake(int time) noexcept;
  ///@}

  ///@{
  /**
   * Called by the device's thread. A sample is a new measurement, made at its Time, or now if Time
   * is 0; a sample with the Time of the last one counts as Confirm. Samples are passed on only
   * while the device is ready, so report one before the stage becomes Ready. The first sample then
   * has Begins set, because the hand may have moved before.
   */
  void Report(const DeviceSample& sample) noexcept;
  /**
   * Reports that the device is connected and has nothing new, so that the tip is still at the last
   * sample. Call it only after a Report since Begin.
   */
  void Confirm() noexcept { this->Samples.Write(this->Told); }
  /**
   * Sets the condition. Texts are cut to the condition's size. Lost stays until DrainHomeRequest or
   * Begin, even if another stage is set, so that nothing resumes by itself.
   */
  void SetCondition(DeviceStage stage, const char* text) noexcept;
  /** Does the same, with the device's name before a text that is not empty. */
  void SetCondition(DeviceStage stage, const char* name, const char* text) noexcept;
  /**
   * Returns whether the computer has slept since the last call; call it once in every round. If the
   * computer has slept, the hand may have moved unseen, and the device is Lost.
   */
  bool HasSlept() noexcept;
  ///@}

  /** Returns the time (ns) that the computer has spent in suspend. */
  static std::int64_t GetTimeAsleep() noexcept;

private:
  struct TimedForce
  {
    Vector3 Force;
    Vector3 Torque;
    std::int64_t Time = 0;
    std::uint32_t TimesReady = 0; ///< the last TimesReady that the servo saw
    std::int64_t Of = 0;          ///< Time of the last sample that the servo got
  };
  void WakeUp() noexcept;
  std::int64_t ReadAsleep() const noexcept
  {
    return this->Asleep != nullptr ? this->Asleep() : GetTimeAsleep();
  }

  const Clock Asleep;
  int Wake = -1;
  std::int64_t SleptBefore = 0; ///< used by the device's thread
  bool IsUnderWay = false; ///< used by the servo: it took a sample since the device became ready
  std::uint32_t TimesReadySeen = 0;           ///< used by the servo
  std::int64_t TimeSeen = 0;                  ///< used by the servo: Time of the last sample
  DeviceSample Told;                          ///< used by the device's thread: the last sample
  std::atomic<std::uint32_t> TimesReady{ 0 }; ///< how often the device became ready
  TripleBuffer<DeviceSample> Samples;
  TripleBuffer<TimedForce> Forces;
  TripleBuffer<TakenForce> TakenForces;
  TripleBuffer<DeviceCondition> Conditions;
  std::atomic<DeviceStage> Stage{ DeviceStage::Lost };
  std::atomic<bool> Quenched{ true };
  /// Rounds of zero force since the last force that was not zero, or since Quench; 2 at most.
  std::atomic<int> ZeroRounds{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<bool> HomeRequested{ false };
  std::atomic<int> Lights{ -1 };
};

} // namespace VolumeHaptics

#endif
