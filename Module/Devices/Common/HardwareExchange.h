// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The exchange between the servo and the thread that talks to a device.
 *
 * Libraries for USB and HID lock and allocate, so that they are called from a thread of their own.
 * Positions come from it and forces go to it by single-producer buffers: the servo never waits, and
 * the device always gets the latest force. A force that nobody renews goes down to zero by itself.
 */
#ifndef HardwareExchange_h
#define HardwareExchange_h

#include "Core/Servo/DeviceBackend.h"
#include "Core/Servo/TripleBuffer.h"

#include <atomic>

namespace VolumeHaptics
{

class HardwareExchange
{
public:
  /** How old (s) a force may become before it fades, and how long that takes. */
  static constexpr double WatchdogTime = 0.03;
  static constexpr double FadeTime = 0.02;

  using Clock = std::int64_t (*)();

  /** The clock tells for how long (ns) the computer has been asleep since it was started. */
  explicit HardwareExchange(Clock asleep = &HardwareExchange::GetTimeAsleep);
  ~HardwareExchange();
  HardwareExchange(const HardwareExchange&) = delete;
  HardwareExchange& operator=(const HardwareExchange&) = delete;

  ///@{
  /**
   * The servo's side. The first sample since the device became ready Begins; where it was not ready
   * for so short a time that no Take came in between, the next one is NotReady all the same.
   */
  DeviceState Take(DeviceSample& sample) noexcept;
  DeviceState Give(const Vector3& force) noexcept;
  ///@}

  ///@{
  /**
   * Any thread: no force until the next Give. At rest once the device's thread has asked for the
   * force twice since then: what it got the first time has been sent by the second.
   */
  void Quench() noexcept;
  bool IsAtRest() const noexcept { return this->ZeroRounds.load(std::memory_order_acquire) > 1; }
  ///@}

  ///@{
  /** The owner's side. Begin forgets everything, before the device's thread starts. */
  void Begin() noexcept;
  void RequestStop() noexcept;
  DeviceCondition GetCondition() noexcept;
  void RequestHome() noexcept;
  void SetLights(int lights) noexcept { this->Lights.store(lights); }
  ///@}

  ///@{
  /**
   * The device's thread: what is asked of it. Lights are below zero where it shows its own
   * condition.
   */
  bool MustStop() const noexcept { return this->StopRequested.load(std::memory_order_acquire); }
  /**
   * Whether homing was requested since the last call. The device is Homing from then on, which the
   * servo sees even where it is ready again at once; no force from before counts.
   */
  bool TakeHomeRequest() noexcept;
  /**
   * Where homing brings nothing back, such as of a device that is unplugged: Lost as before, with
   * the text.
   */
  void RefuseHomeRequest(const char* text) noexcept;
  int GetLights() const noexcept { return this->Lights.load(); }
  /** The force to send now (N): zero unless the device is ready and the servo alive. */
  Vector3 GetForce() noexcept;
  /**
   * A file descriptor that becomes readable with a force, a stop or a homing request; below zero
   * where the system has none. ClearWake makes it wait for the next one.
   */
  int GetWakeDescriptor() const noexcept { return this->Wake; }
  void ClearWake() noexcept;
  ///@}

  ///@{
  /**
   * The device's thread: what it has to tell. A sample is only passed on while the device is ready,
   * so tell one before saying that it is. The first one then Begins: nobody knows what the hand did
   * before.
   */
  void Tell(const DeviceSample& sample) noexcept { this->Samples.Write(sample); }
  /**
   * Texts are cut to the condition's size. Lost stays until TakeHomeRequest or Begin, whatever is
   * told meanwhile, so that nothing resumes by itself.
   */
  void SetCondition(DeviceStage stage, const char* text) noexcept;
  /**
   * Once in every round: true where the computer has slept since the last one, which nobody's hand
   * has felt. The device is Lost then.
   */
  bool HasSlept() noexcept;
  ///@}

  /** The time (ns) that the computer has spent in suspend. */
  static std::int64_t GetTimeAsleep() noexcept;

private:
  struct TimedForce
  {
    Vector3 Force;
    std::int64_t Time = 0;
    std::uint32_t TimesReady = 0; ///< that the servo had seen
  };
  void WakeUp() noexcept;

  const Clock Asleep;
  int Wake = -1;
  std::int64_t SleptBefore = 0; ///< the device thread's
  bool IsUnderWay = false;      ///< the servo's: a sample was taken since the device became ready
  std::uint32_t TimesReadySeen = 0;           ///< the servo's
  std::atomic<std::uint32_t> TimesReady{ 0 }; ///< how often it became so
  TripleBuffer<DeviceSample> Samples;
  TripleBuffer<TimedForce> Forces;
  TripleBuffer<DeviceCondition> Conditions;
  std::atomic<DeviceStage> Stage{ DeviceStage::Lost };
  std::atomic<bool> Quenched{ true };
  /// Since the last force that was not zero, or Quench; 2 at most.
  std::atomic<int> ZeroRounds{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<bool> HomeRequested{ false };
  std::atomic<int> Lights{ -1 };
};

} // namespace VolumeHaptics

#endif
