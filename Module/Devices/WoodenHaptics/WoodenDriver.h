// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * WoodenHaptics with the firmware of 14-byte reports, through hidapi.
 *
 * The device sends its encoder counts at its own rate. The driver sends currents after each packet,
 * or every 2 ms without one; the firmware sets currents to zero that are not renewed for half a
 * second. Homing declares the arm's current pose to be the rest pose, from which the device then
 * counts. The device never reports whether it was calibrated: after power-up all counts are 0, and
 * apart from counts it reports only its calibration button. It is therefore calibrated whenever it
 * is opened, and after every fault.
 *
 * Published firmwares do not identify as a WoodenHaptics: mbed's enumerates as 1234:0006 "HID
 * DEVICE" with packets of 14 bytes (WoodenHaptics/woody-experimental, mbed-code/WoodenHapticsHID,
 * commit 726e186: the defaults of USBDevice/USBHID), Teensy's as 16c0:0486 "Teensyduino RawHID",
 * like other programs on these boards. Therefore nothing is sent to such a device before the user
 * has confirmed with Home() that it is a WoodenHaptics.
 *
 * A Polhem has the same firmware but another linkage, so a device with that name is refused.
 *
 * Published bills of materials have motors of 0.0259 and of 0.0603 N m/A, and current controllers
 * of 3 A and of 6 A at full scale. The actual force may thus be up to four times as strong as
 * requested. Therefore the limits are half of the weakest build's, and the default force, a quarter
 * of the weakest build's, stays within 5 N in all builds.
 *
 * The device's axes are those of all devices: x to the right, y up, z towards the hand. They are y,
 * z and x of WoodenHaptics.h, with the arm reaching towards the user. Not verified on a device.
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
  /** Longest plausible motion (m) of the tip from one packet to the next. */
  static constexpr double FarthestStep = 0.02;
  /** Largest difference (counts) of the encoders from the rest pose just after they were set. */
  static constexpr int RestTolerance = 40;
  /** Longest duration (s) of setting the encoders. */
  static constexpr double PresetTime = 1.0;

  explicit WoodenDriver(int number);

  static bool IsWooden(const HidDeviceInfo& info);
  /**
   * Returns whether this is a Polhem, a related device with another geometry, which this driver
   * does not support.
   */
  static bool IsPolhem(const HidDeviceInfo& info);
  DeviceLimits GetLimits() const override { return { 2.5, 500.0, 0.0, 2.5, 0.0, 0.10 }; }
  std::string GetIdentity() const override { return this->GetInfo().MakeIdentity("wooden"); }

private:
  enum class Phase : std::uint8_t
  {
    Consent,    ///< sends nothing, and waits until the user confirms the device with Home()
    Asking,     ///< waits for the first packet
    Waiting,    ///< waits until the user has moved the arm to its rest pose and requests homing
    Presetting, ///< waits until the counts are those of the rest pose
    Ready
  };

  std::vector<HidDeviceInfo> Choose(std::string& error) const override;
  bool Prepare(const HidDeviceInfo& info, std::string& error) override;
  void Begin(HardwareExchange& exchange, bool isAnew) override;
  void Work(HardwareExchange& exchange) override;
  void Rest() noexcept override;

  void ReceivePacket(HardwareExchange& exchange, const std::uint8_t* bytes, int size);
  void UpdatePhase(HardwareExchange& exchange);
  void UpdateHand(HardwareExchange& exchange);
  bool IsAtRest() const noexcept;
  bool Send(HardwareExchange& exchange, const WoodenHaptics::Packet& packet);

  const int Number;
  const WoodenHaptics Device;
  std::size_t InputSize = WoodenHaptics::PacketSize;
  std::size_t OutputSize = WoodenHaptics::PacketSize;

  Phase Now = Phase::Asking;
  bool HasTip = false; ///< whether the last packet yielded a tip
  Vector3 Tip;
  WoodenHaptics::Input Input;
  std::int64_t LastRound = 0;
  std::int64_t LastSent = 0;
  std::int64_t PresetBegin = 0;
  std::int64_t LastPreset = 0;
  bool HasConsent = false; ///< whether the user has confirmed the device
};

} // namespace VolumeHaptics

#endif
