// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the drivers of HID devices have in common: finding, claiming, the rounds of the thread, and
 * loss.
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
   * And how often it was listened to meanwhile, at least: it is not the device that is late where
   * the host was.
   */
  static constexpr int SilentReads = 20;

  std::string GetName() const override { return this->Label; }
  bool Connect(std::string& error) final;
  void Serve(HardwareExchange& exchange) final;
  void Disconnect() noexcept final { this->Port.Close(); }

protected:
  static constexpr int LongestReport = 256;

  /** The device's name as long as none is open, such as "WoodenHaptics". */
  explicit HidDriver(std::string label)
    : Label(std::move(label))
  {
  }

  ///@{
  /** The parts that differ from kind to kind. */
  /**
   * The devices to try, in this order, where others hold the first ones. None: the reason and the
   * cure.
   */
  virtual std::vector<HidDeviceInfo> Choose(std::string& error) const = 0;
  /** Learns what the device says of itself. False, with the reason and the cure. */
  virtual bool Prepare(const HidDeviceInfo& info, std::string& error) = 0;
  /**
   * At the start of the thread and after a loss, anew; and where homing is requested of one that is
   * well.
   */
  virtual void Begin(HardwareExchange& exchange, bool isAnew) = 0;
  /** As long as the device is not lost: a millisecond or so. */
  virtual void Work(HardwareExchange& exchange) = 0;
  /** Takes the force away, where there is one. */
  virtual void Rest() noexcept = 0;
  /** The last thing that is said to a device that is still there. */
  virtual void End() noexcept { this->Rest(); }
  ///@}

  ///@{
  /** The time to wait is in ms; 0 and a loss where the device is gone. */
  int Read(HardwareExchange& exchange, std::uint8_t* bytes, int time) noexcept;
  /** False and a loss where the device does not take it. */
  bool Write(HardwareExchange& exchange, const std::uint8_t* report, std::size_t size,
    bool isFeature = false) noexcept;
  /** Throws away what is waiting to be read. */
  void Drain() noexcept;
  /** Nothing goes on until homing is requested. The text follows the device's name. */
  void Lose(HardwareExchange& exchange, const char* text) noexcept;
  bool IsLost() const noexcept { return this->Lost; }
  void Tell(HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept;
  ///@}

  /** Whether it is silent, and for too long: after every look for news. */
  bool IsSilent(bool hasNews) noexcept;

  HidPort Port;

private:
  void Restart(HardwareExchange& exchange, bool isAnew);
  void Retreat() noexcept;
  /** While it is lost: a moment, after which it may turn out to be unplugged. */
  void LookWhetherGone(HardwareExchange& exchange) noexcept;

  std::string Label;
  bool Lost = false;
  std::int64_t LastNews = 0;
  int EmptyReads = 0;
  bool Gone = false; ///< unplugged: nothing is to be had from the port any more
};

} // namespace VolumeHaptics

#endif
