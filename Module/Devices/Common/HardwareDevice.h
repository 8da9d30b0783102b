// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device with its own thread for communication.
 */
#ifndef HardwareDevice_h
#define HardwareDevice_h

#include "Core/Realtime/ServoPriority.h"
#include "Core/Safety/DeviceBackend.h"
#include "Devices/Common/HardwareExchange.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace VolumeHaptics
{

/**
 * Converts true newtons to the newtons that are requested from a driver
 * (DeviceBackend::SetForceScale). This is the last step before a device. Any thread may call it.
 */
class TrueNewtons
{
public:
  /**
   * Sets the ratio of true newtons to the driver's newtons. `most` (N) is the largest force that
   * may be requested from the driver.
   */
  void Set(double scale, double most) noexcept
  {
    this->MostAsked.store(most);
    this->Scale.store(scale);
  }
  /** Converts the limits of a device to true newtons, which stay within the driver's limits. */
  DeviceLimits LimitsOf(DeviceLimits limits) const noexcept
  {
    const double share = std::min(1.0, this->Scale.load());
    limits.MaximumForce *= share;
    limits.ContinuousForce *= share;
    return limits;
  }
  /** Returns the force (N) to request from the driver. */
  Vector3 Ask(const Vector3& force) const noexcept
  {
    const double scale = this->Scale.load(std::memory_order_relaxed);
    return scale == 1.0
      ? force
      : ClampNorm((1.0 / scale) * force, this->MostAsked.load(std::memory_order_relaxed));
  }

private:
  std::atomic<double> Scale{ 1.0 };
  std::atomic<double> MostAsked{ 0.0 };
};

class HardwareDriver;

/** Facts that a driver reports about its device. */
struct DriverFacts
{
  explicit DriverFacts(const HardwareDriver& driver);

  std::string Name;
  DeviceLimits Limits;
  std::string Identity;
  bool KeepsIdentity;
};

/** Communicates with the devices of one kind. */
class HardwareDriver
{
public:
  HardwareDriver() = default;
  virtual ~HardwareDriver() = default;
  HardwareDriver(const HardwareDriver&) = delete;
  HardwareDriver& operator=(const HardwareDriver&) = delete;

  virtual std::string GetName() const = 0;
  virtual DeviceLimits GetLimits() const = 0;
  /**
   * Returns DeviceBackend::GetIdentity of the connected device; empty if the device exerts no
   * force.
   */
  virtual std::string GetIdentity() const { return {}; }
  /** Returns DeviceBackend::KeepsIdentity of the connected device. */
  virtual bool KeepsIdentity() const { return true; }

  /**
   * Finds the device and claims it exclusively for this process. On failure, returns false and
   * writes the reason and the cure to `error`.
   */
  virtual bool Connect(std::string& error) = 0;
  /**
   * Runs on the device's thread until the exchange must stop: homes the device, sends forces, and
   * reports positions. Every wait has a time limit. After the device is lost, waits for the stop;
   * if homing is requested and the device is connected, homes it. At the end, sends zero force if
   * possible. Returns early if the device was unplugged and Reconnect() can find it again; the
   * device is then Lost.
   */
  virtual void Serve(HardwareExchange& exchange) = 0;
  /**
   * Reconnects the unplugged device with this identity, and no other device, once it is plugged in
   * again. Returns false if it is missing; if it can't be connected, also writes the reason to
   * `error`. The driver's state is then unchanged. Long waits end once `mustStop` returns true.
   * Called after Disconnect().
   */
  virtual bool Reconnect(const std::string& /*identity*/, const std::function<bool()>& /*mustStop*/,
    std::string& /*error*/)
  {
    return false;
  }
  /**
   * Serves the device until the exchange must stop. Searches for an unplugged device twice a
   * second, and whenever homing is requested. A device that is plugged in again starts like a new
   * one: it is homed if necessary, and exerts no force before the user arms it again.
   */
  void ServeUntilStop(HardwareExchange& exchange);
  /**
   * Sends zero force after the device's thread has crashed in Serve(). The crash handler calls this
   * on the same thread, so it may only use system calls, and neither locks nor heap memory. Does
   * nothing if the device's library needs these.
   */
  virtual void SendLastZero() noexcept {}
  /** Releases the device. Called after Serve(). */
  virtual void Disconnect() noexcept = 0;

private:
  /** Reconnects the device if it has the same facts as before. Returns whether it is connected. */
  bool Return(const DriverFacts& before, const std::function<bool()>& mustStop, std::string& error);
};

class HardwareDevice final : public DeviceBackend
{
public:
  explicit HardwareDevice(std::unique_ptr<HardwareDriver> driver);
  ~HardwareDevice() override;

  bool Open(std::string& error) override;
  void Close() override;
  std::string GetName() const override { return this->Facts.Name; }
  DeviceLimits GetLimits() const override { return this->Newtons.LimitsOf(this->Facts.Limits); }
  std::string GetIdentity() const override { return this->Facts.Identity; }
  bool KeepsIdentity() const override { return this->Facts.KeepsIdentity; }
  void SetForceScale(double scale) noexcept override
  {
    this->Newtons.Set(scale, this->Facts.Limits.MaximumForce);
  }
  DeviceCondition GetCondition() override { return this->Exchange.GetCondition(); }
  void Home() noexcept override { this->Exchange.RequestHome(); }
  void SetLights(int lights) noexcept override { this->Exchange.SetLights(lights); }

  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    return this->Exchange.Receive(sample);
  }
  DeviceState Write(const Vector3& force) noexcept override
  {
    return this->Exchange.Give(this->Newtons.Ask(force));
  }
  DeviceState Send(const DeviceCommand& command) noexcept override
  {
    return this->Exchange.Give(this->Newtons.Ask(command.Force), command.Torque);
  }
  void Quench() noexcept override { this->Exchange.Quench(); }
  bool IsAtRest() const noexcept override { return this->Exchange.IsAtRest(); }

private:
  void Run();
  /** Requests a real-time scheduling class for the thread, without waiting for the answer. */
  void SeekPriority();

  std::unique_ptr<HardwareDriver> Driver;
  /**
   * Facts from the last Open(), stored here because the driver's thread may reconnect the device.
   */
  DriverFacts Facts;
  HardwareExchange Exchange;
  TrueNewtons Newtons;
  std::thread Thread;
  std::unique_ptr<ServoPriority> Priority; // requests the priority of Thread
  std::thread Request;                     // thread of SeekPriority's request, if any
  std::int64_t Process = 0;                // id of the process that owns the threads
  // whether this object is in a forked child, in which the threads don't exist
  bool IsAbandoned = false;
};

} // namespace VolumeHaptics

#endif
