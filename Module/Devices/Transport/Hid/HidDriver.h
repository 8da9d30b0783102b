// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The base class of drivers for HID devices. It finds and claims a device, runs the loop of its
 * thread, and handles its loss.
 */
#ifndef HidDriver_h
#define HidDriver_h

#include "Devices/Common/DeviceKind.h"
#include "Devices/Common/DeviceTexts.h"
#include "Devices/Common/HardwareDevice.h"
#include "Devices/Transport/Hid/HidPort.h"

namespace VolumeHaptics
{

class HidDriver : public HardwareDriver
{
public:
  /** Longest silence (s) of a device that sends reports by itself. */
  static constexpr double SilenceTime = 0.1;
  /**
   * Smallest number of reads within SilenceTime before the device counts as silent, because this
   * computer itself may have been delayed.
   */
  static constexpr int SilentReads = 20;

  std::string GetName() const override { return this->Label; }
  bool Connect(std::string& error) final;
  void Serve(HardwareExchange& exchange) final;
  bool Reconnect(
    const std::string& identity, const std::function<bool()>& mustStop, std::string& error) final;
  void SendLastZero() noexcept final;
  void Disconnect() noexcept final { this->Port.Close(); }
  bool KeepsIdentity() const final { return this->Info.KeepsIdentity(); }

protected:
  static constexpr int LongestReport = 256;

  /** @param label name of the device while none is open, such as "WoodenHaptics" */
  explicit HidDriver(std::string label)
    : Label(std::move(label))
  {
  }

  ///@{
  /** The functions that differ between kinds. */
  /**
   * Returns the devices to try, in order; devices in use are skipped. If there are none, returns an
   * empty list and writes the reason and the cure to `error`.
   */
  virtual std::vector<HidDeviceInfo> Choose(std::string& error) const = 0;
  /**
   * Reads the device's own description. On failure, returns false and writes the reason and the
   * cure to `error`.
   */
  virtual bool Prepare(const HidDeviceInfo& info, std::string& error) = 0;
  /**
   * Called when the thread begins, after a loss (with isAnew true), and when homing of a working
   * device is requested.
   */
  virtual void Begin(HardwareExchange& exchange, bool isAnew) = 0;
  /** Called repeatedly while the device is not lost. Takes about a millisecond. */
  virtual void Work(HardwareExchange& exchange) = 0;
  /** Ends the force, if any. */
  virtual void Rest() noexcept = 0;
  /** Sends the final message before a connected device is closed. By default, ends the force. */
  virtual void End() noexcept { this->Rest(); }
  ///@}

  ///@{
  /**
   * Reads a report. Waits at most `time` (ms). If the device is gone, returns 0 and records the
   * loss.
   */
  int Read(HardwareExchange& exchange, std::uint8_t* bytes, int time) noexcept;
  /** Writes a report. If the device refuses it, returns false and records a loss. */
  bool Write(HardwareExchange& exchange, const std::uint8_t* report, std::size_t size,
    bool isFeature = false) noexcept;
  /** Discards all pending reports. */
  void Drain() noexcept;
  /**
   * Stops all work until homing is requested. The condition's text begins with the device's name.
   */
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  bool IsLost() const noexcept { return this->Lost; }
  void Report(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;
  ///@}

  /**
   * Returns whether the device has been silent for too long. Must be called after every read;
   * `hasNews` is whether a report was read.
   */
  bool IsSilent(bool hasNews) noexcept;

  /** Returns the device that was connected last. */
  const HidDeviceInfo& GetInfo() const noexcept { return this->Info; }

  HidPort Port;

private:
  bool Take(const HidDeviceInfo& info, std::string& error);
  /**
   * Returns whether the device can be identified when it is plugged in again: its serial number is
   * unique, or it exerts no force.
   */
  bool CanReturn() const
  {
    return (this->KeepsIdentity() && !this->HasTwin) || this->GetIdentity().empty();
  }
  const char* GetUnpluggedText() const { return this->CanReturn() ? UnpluggedText : OpenAgainText; }
  /** Lists the devices that may be the previous device or its twins. */
  std::vector<HidDeviceInfo> ListLike(const HidDeviceInfo& before) const;
  /** Records whether another device with the same names and serial number is plugged in. */
  void LookForTwin();
  void Restart(HardwareExchange& exchange, bool isAnew);
  void Retreat() noexcept;
  /** While the device is lost, waits for a moment, and then checks whether it is unplugged. */
  void LookWhetherGone(HardwareExchange& exchange) noexcept;

  std::string Label;
  HidDeviceInfo Info;
  bool HasTwin = false;
  bool Lost = false;
  std::int64_t LastNews = 0;
  int EmptyReads = 0;
  bool Gone = false; ///< whether the device is unplugged, so that its port is no longer usable
};

} // namespace VolumeHaptics

#endif
