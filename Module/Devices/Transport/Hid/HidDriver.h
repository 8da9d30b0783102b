// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The base of the drivers of HID devices: it finds and claims a device, runs the rounds of its
 * thread, and handles loss.
 */
#ifndef HidDriver_h
#define HidDriver_h

#include "Devices/Common/DeviceKind.h"
#include "Devices/Common/HardwareDevice.h"
#include "Devices/Transport/Hid/HidPort.h"

namespace VolumeHaptics
{

class HidDriver : public HardwareDriver
{
public:
  /** How long (s) a device that reports by itself may be silent. */
  static constexpr double SilenceTime = 0.1;
  /**
   * The smallest number of reads during SilenceTime: if the host was late, the device is not
   * silent.
   */
  static constexpr int SilentReads = 20;

  std::string GetName() const override { return this->Label; }
  bool Connect(std::string& error) final;
  void Serve(HardwareExchange& exchange) final;
  void Disconnect() noexcept final { this->Port.Close(); }
  bool KeepsIdentity() const final { return this->Info.KeepsIdentity(); }

protected:
  static constexpr int LongestReport = 256;

  /** `label` names the device while none is open, such as "WoodenHaptics". */
  explicit HidDriver(std::string label)
    : Label(std::move(label))
  {
  }

  ///@{
  /** The parts that differ between kinds. */
  /**
   * Returns the devices to try, in order: if one is in use, the next one is tried. If there are
   * none, returns an empty list and writes the reason and the cure to `error`.
   */
  virtual std::vector<HidDeviceInfo> Choose(std::string& error) const = 0;
  /**
   * Reads the device's description of itself. If this fails, returns false and writes the reason
   * and the cure to `error`.
   */
  virtual bool Prepare(const HidDeviceInfo& info, std::string& error) = 0;
  /**
   * Called at the start of the thread, after a loss (then with `isAnew`), and if homing is
   * requested from a working device.
   */
  virtual void Begin(HardwareExchange& exchange, bool isAnew) = 0;
  /** Called repeatedly while the device is not lost; takes about a millisecond. */
  virtual void Work(HardwareExchange& exchange) = 0;
  /** Ends the force, if there is one. */
  virtual void Rest() noexcept = 0;
  /** Sends the last message to a connected device. */
  virtual void End() noexcept { this->Rest(); }
  ///@}

  ///@{
  /**
   * Reads a report; `time` (ms) limits the wait. If the device is gone, returns 0 and records a
   * loss.
   */
  int Read(HardwareExchange& exchange, std::uint8_t* bytes, int time) noexcept;
  /** Writes a report. If the device refuses it, returns false and records a loss. */
  bool Write(HardwareExchange& exchange, const std::uint8_t* report, std::size_t size,
    bool isFeature = false) noexcept;
  /** Drops the reports that wait to be read. */
  void Drain() noexcept;
  /** Stops all work until homing is requested. The text follows the device's name. */
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  bool IsLost() const noexcept { return this->Lost; }
  void Report(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;
  ///@}

  /** Returns whether the device has been silent for too long. Call it after every read. */
  bool IsSilent(bool hasNews) noexcept;

  /** Returns the device that was connected last. */
  const HidDeviceInfo& GetInfo() const noexcept { return this->Info; }

  HidPort Port;

private:
  void Restart(HardwareExchange& exchange, bool isAnew);
  void Retreat() noexcept;
  /** Waits a moment while the device is lost, and checks whether the device is unplugged. */
  void LookWhetherGone(HardwareExchange& exchange) noexcept;

  std::string Label;
  HidDeviceInfo Info;
  bool Lost = false;
  std::int64_t LastNews = 0;
  int EmptyReads = 0;
  bool Gone = false; ///< whether the device is unplugged, so that the port can't be used any more
};

} // namespace VolumeHaptics

#endif
