// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A DualSense through hidapi, for systems whose own driver can't make it vibrate.
 *
 * The pad vibrates, but exerts no force (Vibration.h, PadState.h). The first report shows whether
 * it is connected by cable or by Bluetooth. The pad has no documented watchdog: on Linux, a guard
 * (Devices/Guard) ends the vibration if the program can't. Not verified on hardware.
 */
#ifndef DualSenseDriver_h
#define DualSenseDriver_h

#include "Devices/Common/RateTip.h"
#include "Devices/Pad/DualSense.h"
#include "Devices/Pad/PadLimits.h"
#include "Devices/Pad/Vibration.h"
#include "Devices/Transport/Hid/HidDriver.h"

namespace VolumeHaptics
{

class DualSenseDriver final : public HidDriver
{
public:
  /** Time (s) between changes; the end of vibration is sent at once. */
  static constexpr double SendPeriod = 0.01;

  /** @param number index of the device in the list of Find() */
  explicit DualSenseDriver(int number);

  ///@{
  /**
   * Convert the number to words of a command line, and back. MakeFromWords() returns null if the
   * words belong to another driver.
   */
  static std::vector<std::string> MakeWords(int number);
  static std::unique_ptr<HardwareDriver> MakeFromWords(const std::vector<std::string>& words);
  ///@}

  static bool IsDualSense(const HidDeviceInfo& info);
  std::string GetName() const override { return HidDriver::GetName() + ", vibration, not force"; }
  DeviceLimits GetLimits() const override { return MakePadLimits(); }

private:
  std::vector<HidDeviceInfo> Choose(std::string& error) const override;
  /** Determines link and firmware version, and sends zero. */
  bool Prepare(const HidDeviceInfo& info, std::string& error) override;
  void Begin(HardwareExchange& exchange, bool isAnew) override;
  void Work(HardwareExchange& exchange) override;
  void Rest() noexcept override { this->Send(0, 0); }

  bool Send(int strong, int weak) noexcept;
  bool Listen(HardwareExchange& exchange);
  void Show(HardwareExchange& exchange);

  const int Number;
  DualSense::Link Link = DualSense::Link::Unknown;
  bool IsNewer = false; ///< whether the firmware supports the newer vibration
  unsigned Reports = 0; ///< number of reports sent
  PadState State;
  RateTip Tip;
  Vibration Levels;
  int Strong = 0; ///< last level sent to the strong motor
  int Weak = 0;   ///< last level sent to the weak motor
  int BadReports = 0;
  std::int64_t SentAt = 0;
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
