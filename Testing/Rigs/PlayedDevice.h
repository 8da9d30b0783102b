// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A back end that plays back a tip path and records the loop's forces, and a loop that runs on it.
 */
#ifndef PlayedDevice_h
#define PlayedDevice_h

#include "Core/Servo/ServoLoop.h"
#include "CoreScene.h"
#include "Eventually.h"
#include "Growth.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace servotest
{
using namespace coretest;
using devicetest::Eventually;

class PlayedDevice : public DeviceBackend
{
public:
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "played"; }
  DeviceLimits GetLimits() const override { return {}; }

  /// Returns the position (m) at a tick on a path that goes up and down along z and slightly
  /// sideways. By the clock of a loop at 5 kHz, its speed is at most 0.3 m/s.
  static Vector3 TipOf(std::uint64_t tick)
  {
    const double phase = 2e-3 * static_cast<double>(tick);
    return { 0.012 + 0.004 * std::sin(0.37 * phase), 0.012, 0.012 + 0.007 * std::sin(phase) };
  }

  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    const std::uint64_t tick = this->Reads.fetch_add(1);
    while (tick - std::min(tick, this->ReaderAt.load()) > FarthestBehind)
    {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    sample.Fresh = !this->Frozen.load();
    if (sample.Fresh)
    {
      sample.Tip = TipOf(tick);
    }
    this->InTick();
    return this->ReadLost.load() ? DeviceState::Lost : DeviceState::Running;
  }

  DeviceState Write(const Vector3& force) noexcept override
  {
    const double norm = Norm(force);
    const std::uint64_t number = this->Writes.load() + 1; // only this thread writes the count
    this->LargestGrowth = std::max(this->LargestGrowth, GrowthOf(this->Last, force));
    this->Last = force;
    this->LargestForce.store(std::max(this->LargestForce.load(), norm));
    this->Force.store(norm);
    if (norm > 0.0)
    {
      this->LastPush.store(number);
    }
    this->Writes.store(number);
    return this->WriteLost.load() ? DeviceState::Lost : DeviceState::Running;
  }

  void Quench() noexcept override {}

  /// @{
  /// The tick that a reader of the loop's ring has reached; if the reader is far behind, ticks
  /// wait.
  static constexpr std::uint64_t FarthestBehind = 500;
  std::atomic<std::uint64_t> ReaderAt{ std::numeric_limits<std::uint64_t>::max() };
  ///@}
  std::atomic<bool> Frozen{ false };
  std::atomic<bool> ReadLost{ false };
  std::atomic<bool> WriteLost{ false };
  std::atomic<std::uint64_t> Reads{ 0 };
  std::atomic<std::uint64_t> Writes{ 0 };
  std::atomic<std::uint64_t> LastPush{ 0 }; ///< number of the last write of a force other than zero
  std::atomic<double> Force{ 0.0 };         ///< N, norm of the last force
  std::atomic<double> LargestForce{ 0.0 };
  double LargestGrowth = 0.0; ///< N per tick, largest growth of the force; read it after the loop
                              ///< has ended

protected:
  /// Called once per tick on the servo's thread.
  virtual void InTick() noexcept {}

private:
  Vector3 Last;
};

/**
 * Makes the loop wait for its reader during the object's lifetime. The ring has room for 0.4 s of
 * ticks, which is not enough for a reader under a sanitizer on a busy machine.
 */
class ReaderPace
{
public:
  explicit ReaderPace(PlayedDevice& device)
    : Device(device)
  {
    this->Device.ReaderAt.store(this->Device.Reads.load());
  }
  ~ReaderPace() { this->Device.ReaderAt.store(std::numeric_limits<std::uint64_t>::max()); }
  /// Reads all ticks that are in the ring.
  template <typename F>
  void Drain(ServoLoop* loop, F&& take) const
  {
    for (ServoSnapshot tick; loop->Drain(tick);)
    {
      this->Device.ReaderAt.store(tick.Tick);
      take(tick);
    }
  }

private:
  PlayedDevice& Device;
};

inline SafetyLimits QuickLimits()
{
  SafetyLimits limits;
  limits.MaximumForce = 4.0;
  limits.RampTime = 0.01;
  // Disable the watchdog, which would mistake a busy machine for a frozen device.
  limits.WatchdogTime = 60.0;
  return limits;
}

/// Returns how many loops a test runs in sequence. Sanitizers are slow, but detect a race within a
/// few loops.
constexpr int Lives(int count)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return count / 5;
#else
  return count;
#endif
}

/// A loop that runs during the object's lifetime.
class RunningLoop
{
public:
  explicit RunningLoop(DeviceBackend& device, double rate = 5000.0, SafetyLimits l = QuickLimits())
    : Loop(device, rate)
  {
    this->Loop.SetLimits(l);
    this->Thread = std::thread([this] { this->Loop.Run(); });
    this->Fitter = std::thread([this] { this->Loop.RunFitter(); });
  }
  ~RunningLoop()
  {
    this->Loop.RequestStop();
    this->Thread.join();
    this->Fitter.join();
  }
  ServoLoop* operator->() { return &this->Loop; }

private:
  ServoLoop Loop;
  std::thread Thread;
  std::thread Fitter;
};
} // namespace servotest

#endif
