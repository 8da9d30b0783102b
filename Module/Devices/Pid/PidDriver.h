// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Force-feedback sticks and wheels (HID PID) through hidapi.
 *
 * A stick with two axes needs a known firmware (PidFirmware.h), because firmwares differ in the
 * direction in which an effect pushes the second axis. Other sticks with two axes are refused
 * unless the user sets the second NewtonsPerFullScale to 0, which states that only the first axis
 * has a motor.
 *
 * The axes move a tip in a plane by up to 5 cm in each direction: x to the right and y away from
 * the hand; HID's own y axis points towards the hand. With a device of one axis, the tip moves only
 * along x, because the second axis may be a pedal. Effects end by themselves within 0.1 s of the
 * host's last report. Many sticks send nothing at rest, so the last position stays valid; the
 * driver checks the connection by sending such a stick at least one report every 10 ms. Others
 * repeat their reports, OpenFFBoard for example every 0.1 s; they are lost if two repeats are
 * missing.
 *
 * The kernel's PID driver uses the same device. A game that uses that driver at the same time would
 * interfere. Documentation/devices/wheels.md explains why this driver uses hidraw.
 */
#ifndef PidDriver_h
#define PidDriver_h

#include "Devices/Pid/HidStick.h"
#include "Devices/Pid/PidDialogue.h"
#include "Devices/Transport/Hid/HidDeviceInfo.h"
#include "Devices/Transport/Hid/HidDriver.h"

#include <optional>

namespace VolumeHaptics
{

/**
 * Detects which published firmware a force-feedback device runs, and which way it pushes.
 *
 * The PID specification does not define whether a direction is that from which a force comes or
 * that in which it acts, and firmwares differ. Two are known from their source code, in which the
 * torque of their own springs shows the sign of their axes:
 *
 * - OpenFFBoard (Ultrawipf/OpenFFBoard, HidFFB.cpp and EffectsCalculator.cpp, commit 160af910): a
 *   force comes from its direction, as in DirectInput and in Linux' hid-pidff. Versions 1.10.0 to
 *   1.16.0 push y in the opposite direction. All versions have the same numbers and reports, but
 *   since 1.16.5 the name of the board follows "FFBoard " in the product's name. Built with the
 *   descriptor of one axis, it looks for Direction Enable in a bit that the descriptor lacks, and
 *   uses the bit of the axis: its direction is then a fraction of the force, from -1 at one end of
 *   the range to 1 at the other.
 * - ArduinoJoystickWithFFBLibrary (YukMingLaw's, Joystick.cpp, commit ed86e27): a force acts in its
 *   direction. It is identified by its board's maker and the sizes of all its reports.
 *
 * All other firmwares are treated as in hid-pidff. If they have two axes, only the first axis is
 * used, provided that the user states that the second one has no motor.
 */
struct PidFirmware
{
  bool IsKnown = false; ///< whether the signs of both axes are known
  double Sign = 1.0;    ///< -1 if a force acts in its direction, 1 if it comes from it
  /// whether a direction is a fraction of the force on the axis whose bit is set
  bool HasShares = false;
  const char* Objection = ""; ///< reason why no axis can be driven; empty if one can
};

PidFirmware DetectPidFirmware(const HidDeviceInfo& info, const HidReportDescriptor& descriptor);

class PidDriver final : public HidDriver
{
public:
  static constexpr double Travel = 0.05; ///< position of the tip (m) at the end of an axis
  /** Largest plausible speed of a stick (m/s): its whole travel in 20 ms. */
  static constexpr double FastestStick = 5.0;

  /** The devices that an id selects: all devices, or the devices of a vendor and product. */
  struct Numbers
  {
    bool Any = true;
    std::uint16_t Vendor = 0;
    std::uint16_t Product = 0;
  };
  /** Reads the numbers of an id. Returns false if the id is neither "pid" nor "pid:VVVV:PPPP". */
  static bool ReadNumbers(const std::string& id, Numbers& numbers);
  /**
   * Returns whether the report descriptor contains everything that forces require. If the device
   * gets no forces for another reason, `objection` receives the reason and the cure; otherwise it
   * is empty.
   */
  static bool IsPid(const HidDeviceInfo& info, std::string& objection);

  PidDriver(const Numbers& numbers, const std::array<double, 2>& newtonsPerFullScale);

  DeviceLimits GetLimits() const override;
  /**
   * Returns an identity that includes the axes that the user has reversed, because each combination
   * needs its own confirmation.
   */
  std::string GetIdentity() const override;

private:
  /** Describes how to drive a device, according to its descriptor and its names. */
  struct Mapping
  {
    PidDevice Device;
    HidStick Stick;
    PidFirmware Firmware;
    /** Reason why a device that has the parts for forces gets none; empty if it gets forces. */
    std::string Objection;

    /**
     * Reads the mapping from a device's report descriptor. If the descriptor lacks required parts,
     * returns false and names them in `error`.
     */
    bool Read(const HidDeviceInfo& info, bool usesSecond, std::string& error);
  };

  bool UsesSecondAxis() const noexcept { return this->NewtonsPerFullScale[1] != 0.0; }
  std::vector<HidDeviceInfo> Choose(std::string& error) const override;
  bool Prepare(const HidDeviceInfo& info, std::string& error) override;
  void Begin(HardwareExchange& exchange, bool isAnew) override;
  void Work(HardwareExchange& exchange) override;
  void Rest() noexcept override;
  void End() noexcept override;

  void GoOnWithDialogue(HardwareExchange& exchange);
  void Fetch(HidReport& report);
  bool Listen(HardwareExchange& exchange);
  void ReportPlace(HardwareExchange& exchange);
  /** Sends the forces. Returns whether the device has received a report. */
  bool SendForces(HardwareExchange& exchange);
  bool Send(HardwareExchange& exchange, const HidReport& report) noexcept;

  const Numbers Wanted;
  const std::array<double, 2> NewtonsPerFullScale;
  PidSettings Settings; ///< settings, with the firmware's sign
  Mapping Map;

  std::optional<PidDialogue> Dialogue;
  std::optional<PidStream> Stream; ///< exists when the dialogue is complete
  HidStick::State State;           ///< an axis that was not reported yet is NaN
  bool IsReady = false;
  std::array<std::uint8_t, LongestReport> LastPacket{};
  int LastSize = 0;
  int Repeats = 0; ///< number of consecutive packets equal to the previous one
  std::int64_t LastPacketTime = 0;
  std::int64_t LongestGap = 0; ///< longest gap before a repeated packet (ns)
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
