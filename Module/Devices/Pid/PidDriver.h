// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Force-feedback sticks and wheels (HID PID) through hidapi.
 *
 * Only devices of one axis, such as wheels, get forces. Published firmwares disagree on the
 * direction in which an effect pushes the second axis of a stick: OpenFFBoard's of 2021 (commit
 * 021d967) gives y the share of x; that of 2024 takes another angle for each axis whose bit is set,
 * and pushes y backwards if none is. All sticks of two axes are refused, even those that only use
 * directions.
 *
 * A stick's axes are a tip in a plane: x to the right, y away from the hand, at most 5 cm each way;
 * HID's own y axis points towards the hand. Its effects end by themselves within 0.1 s of the
 * host's last report. Many sticks send nothing while they rest, so the last position stays valid. A
 * stick that repeats its reports is not one of these: if it falls silent, it is lost.
 *
 * The kernel's own PID driver uses the same device: while a game does so, the two disturb each
 * other.
 */
#ifndef PidDriver_h
#define PidDriver_h

#include "Devices/Pid/HidStick.h"
#include "Devices/Pid/PidDialogue.h"
#include "Devices/Transport/Hid/HidDriver.h"

#include <optional>

namespace VolumeHaptics
{

class PidDriver final : public HidDriver
{
public:
  static constexpr double Travel = 0.05; ///< m, of the tip at the end of an axis
  /** m/s, the whole way in 20 ms. No hand is faster. */
  static constexpr double FastestStick = 5.0;

  /** The devices that an id means: all, or those of a vendor and product. */
  struct Numbers
  {
    bool Any = true;
    std::uint16_t Vendor = 0;
    std::uint16_t Product = 0;
  };
  /** False for an id that is neither "pid" nor "pid:VVVV:PPPP". */
  static bool ReadNumbers(const std::string& id, Numbers& numbers);
  /**
   * Whether its report descriptor has all that forces need. The objection tells why such a device
   * gets no forces, and the cure; it is empty if it gets them.
   */
  static bool IsPid(const HidDeviceInfo& info, std::string& objection);

  PidDriver(const Numbers& numbers, const std::array<double, 2>& newtonsPerFullScale);

  DeviceLimits GetLimits() const override;

private:
  std::vector<HidDeviceInfo> Choose(std::string& error) const override;
  bool Prepare(const HidDeviceInfo& info, std::string& error) override;
  void Begin(HardwareExchange& exchange, bool isAnew) override;
  void Work(HardwareExchange& exchange) override;
  void Rest() noexcept override;
  void End() noexcept override;

  void GoOnWithDialogue(HardwareExchange& exchange);
  void Fetch(HidReport& report);
  bool Listen(HardwareExchange& exchange);
  void TellPlace(HardwareExchange& exchange);
  void SendForces(HardwareExchange& exchange);
  bool Send(HardwareExchange& exchange, const HidReport& report) noexcept;

  const Numbers Wanted;
  PidSettings Settings;
  PidDevice Device;
  HidStick Stick;

  std::optional<PidDialogue> Dialogue;
  std::optional<PidStream> Stream; ///< once the dialogue is over
  HidStick::State State;           ///< axes that were not reported yet are NaN
  bool IsReady = false;
  std::array<std::uint8_t, LongestReport> LastPacket{};
  int LastSize = 0;
  int Repeats = 0; ///< packets that equal the one before
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
