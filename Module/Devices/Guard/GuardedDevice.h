// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device behind a guard. The guard is a small separate process, which outlives this one.
 *
 * A device without a watchdog keeps exerting its last force if the program dies or is stopped.
 * Therefore the guard communicates with the device, and shares an exchange (HardwareExchange.h) in
 * memory with the program. For the servo this is like a separate thread: it neither waits nor
 * locks. A force that is not renewed within 50 ms, for whatever reason, becomes zero in the guard.
 * If the program ends in any way, the system notifies the guard, which sends zero at once, releases
 * the device and ends.
 *
 *   program                          guard (volumehaptics-guard)
 *   servo ---- force ---> exchange ---> driver ---> device
 *         <--- sample ---          <---        <---
 *   socket, hangs up at the end of either side
 *
 * If the guard itself ends, the device is Lost, and this process sends zero in its place. To allow
 * this, a guard that was stopped (SIGSTOP) is killed.
 */
#ifndef GuardedDevice_h
#define GuardedDevice_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Guard/GuardProcess.h"

namespace VolumeHaptics
{

class GuardedDevice final : public DeviceBackend
{
public:
  /**
   * Makes a device that a guard serves. The guard receives `words` on its command line and makes
   * its own driver from them. `driver` is the driver in this process: it provides the limits. It
   * connects to the device only after the guard has ended, so its Reconnect() must send zero. On
   * failure, returns null and writes the reason to `error`.
   */
  static std::unique_ptr<GuardedDevice> Make(
    std::unique_ptr<HardwareDriver> driver, std::vector<std::string> words, std::string& error);
  ~GuardedDevice() override;

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
  DeviceCondition GetCondition() override;
  void Home() noexcept override;
  void SetLights(int lights) noexcept override;

  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override;
  bool IsAtRest() const noexcept override;

private:
  enum class Side : std::uint8_t
  {
    Guard,  ///< the guard has the device
    Rescue, ///< the guard has ended, and this process is sending zero
    None    ///< neither process has the device; zero force was sent last
  };

  GuardedDevice(std::unique_ptr<HardwareDriver> driver, std::vector<std::string> words);
  void Watch();
  void Rescue() noexcept;
  bool IsForked() const noexcept;
  HardwareExchange& GetExchange() noexcept { return this->Memory->GetExchange(); }

  std::unique_ptr<HardwareDriver> Driver;
  DriverFacts Facts; ///< limits of this process's driver, name and identity of the guard's device
  const std::vector<std::string> Words;
  std::unique_ptr<GuardMemory> Memory;
  GuardProcess Guard;
  TrueNewtons Newtons;
  std::thread Watcher;
  std::int64_t Process = 0;       ///< process that has started the guard
  bool IsAbandoned = false;       ///< whether this object is in a forked child
  DeviceCondition EndedCondition; ///< condition after the guard has released the device
  std::atomic<Side> HasDevice{ Side::Guard };
  std::atomic<bool> IsClosing{ false };
};

} // namespace VolumeHaptics

#endif
