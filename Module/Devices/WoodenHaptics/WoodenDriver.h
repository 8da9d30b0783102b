// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * WoodenHaptics with the firmware of 14-byte reports, through hidapi.
 *
 * The device sends its encoders at its own rate and gets its currents after each packet, or every 2
 * ms without one; its firmware takes currents back that nobody renews for half a second. It knows
 * where the arm is once it was told so in the rest pose: that is what homing is for. It never says
 * whether it was: when power comes all its counts are 0, and what it reports beside them is its
 * calibration button. So it is calibrated anew whenever it is opened, and after every fault.
 *
 * A Polhem has the same firmware with another linkage; it is refused.
 *
 * The device's space is that of all devices: x to the right, y up, z towards the hand, which are y,
 * z and x of WoodenHaptics.h with the arm reaching towards whoever holds it. Not verified on a
 * device.
 */
#ifndef WoodenDriver_h
#define WoodenDriver_h

#include "Devices/Transport/Hid/HidDriver.h"
#include "Devices/WoodenHaptics/WoodenHaptics.h"

namespace VolumeHaptics
{

class WoodenDriver final : public HidDriver
{
public:
  /** How far (m) the tip comes from one packet to the next, at most: no hand is as fast. */
  static constexpr double FarthestStep = 0.02;
  /** How far (counts) from the rest pose the encoders may be right after they were set. */
  static constexpr int RestTolerance = 40;
  /** How long (s) the device may take to set its encoders. */
  static constexpr double PresetTime = 1.0;

  explicit WoodenDriver(int number);

  static bool IsWooden(const HidDeviceInfo& info);
  /** The sister with another geometry, which this driver does not have. */
  static bool IsPolhem(const HidDeviceInfo& info);
  DeviceLimits GetLimits() const override { return { 5.0, 1000.0, 0.0, 2.5, 0.0, 0.10 }; }

private:
  enum class Phase : std::uint8_t
  {
    Asking,     ///< for the first packet
    Waiting,    ///< for the hand to put the arm into its rest pose and to ask for homing
    Presetting, ///< until the encoders read as they have to
    Ready
  };

  std::vector<HidDeviceInfo> Choose(std::string& error) const override;
  bool Prepare(const HidDeviceInfo& info, std::string& error) override;
  void Begin(HardwareExchange& exchange, bool isAnew) override;
  void Work(HardwareExchange& exchange) override;
  void Rest() noexcept override;

  void TakePacket(HardwareExchange& exchange, const std::uint8_t* bytes, int size);
  void FollowPhase(HardwareExchange& exchange);
  void FollowHand(HardwareExchange& exchange);
  bool IsAtRest() const noexcept;
  void Send(HardwareExchange& exchange, const WoodenHaptics::Packet& packet);

  const int Number;
  const WoodenHaptics Device;
  std::size_t InputSize = WoodenHaptics::PacketSize;
  std::size_t OutputSize = WoodenHaptics::PacketSize;

  Phase Now = Phase::Asking;
  bool HasTip = false; ///< of the packet before
  Vector3 Tip;
  WoodenHaptics::Input Input;
  std::int64_t LastRound = 0;
  std::int64_t LastSent = 0;
  std::int64_t PresetBegin = 0;
};

} // namespace VolumeHaptics

#endif
