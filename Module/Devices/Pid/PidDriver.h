// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Force-feedback sticks and wheels (HID PID) through hidapi.
 *
 * A stick with two axes needs a known firmware (PidFirmware.h), because firmwares differ in the
 * direction in which an effect pushes the second axis. Other sticks with two axes are refused,
 * unless the user sets a second NewtonsPerFullScale of 0 to state that only the first axis has a
 * motor.
 *
 * The axes are a tip in a plane: x points to the right and y away from the hand, at most 5 cm in
 * each direction; HID's own y axis points towards the hand. With a device of one axis, the tip
 * moves only along x: the second axis may be a pedal. Effects end by themselves within 0.1 s of the
 * host's last report. Many sticks send nothing at rest, so that the last position stays valid. Such
 * a stick shows that it is connected by receiving reports, at least one every 10 ms. Others repeat
 * their reports, OpenFFBoard for example every 0.1 s; they are lost if two repeats do not come.
 *
 * The kernel's PID driver uses the same device. If a game uses it at the same time, the two disturb
 * each other. Documentation/devices/wheels.md explains why this driver uses hidraw.
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
 * The PID specification leaves open whether a direction is where a force comes from or where it
 * goes to, and firmwares differ. Two are known from their source, where the torque of their own
 * springs shows the sign of their axes:
 *
 * - OpenFFBoard (Ultrawipf/OpenFFBoard, HidFFB.cpp and EffectsCalculator.cpp, commit 160af910): a
 *   force comes from its direction, as in DirectInput and in Linux' hid-pidff. Versions 1.10.0 to
 *   1.16.0 push y the other way. Versions have the same numbers and reports, but since 1.16.5 the
 *   name of the board follows "FFBoard " in the product's name. Built with the descriptor of one
 *   axis, it looks for Direction Enable in a bit that the descriptor does not have, and uses the
 *   bit of the axis: then its direction is a share, from -1 at one end of the range to 1 at the
 *   other.
 * - ArduinoJoystickWithFFBLibrary (YukMingLaw's, Joystick.cpp, commit ed86e27): a force goes to its
 *   direction. It is identified by its board's maker and the sizes of all its reports.
 *
 * All others are treated like hid-pidff. If they have two axes, only the first one is used, where
 * the user states that the second one has no motor.
 */
struct PidFirmware
{
  bool IsKnown = false;       ///< whether the signs of both axes are known
  double Sign = 1.0;          ///< -1 if a force goes to its direction, 1 if it comes from it
  bool HasShares = false;     ///< whether a direction is a share of the axis whose bit is set
  const char* Objection = ""; ///< reason why no axis can be driven; empty if one can
};

PidFirmware DetectPidFirmware(const HidDeviceInfo& info, const HidReportDescriptor& descriptor);

class PidDriver final : public HidDriver
{
public:
  static constexpr double Travel = 0.05; ///< position of the tip in m at the end of an axis
  /** Largest speed of a stick (m/s), which is its whole way in 20 ms. No hand is faster. */
  static constexpr double FastestStick = 5.0;

  /** The devices that an id means: all devices, or the devices of a vendor and product. */
  struct Numbers
  {
    bool Any = true;
    std::uint16_t Vendor = 0;
    std::uint16_t Product = 0;
  };
  /** Reads the numbers of an id. Returns false if the id is neither "pid" nor "pid:VVVV:PPPP". */
  static bool ReadNumbers(const std::string& id, Numbers& numbers);
  /**
   * Returns whether the report descriptor has everything that forces need. If the device gets no
   * forces for another reason, `objection` receives the reason and the cure; otherwise it is empty.
   */
  static bool IsPid(const HidDeviceInfo& info, std::string& objection);

  PidDriver(const Numbers& numbers, const std::array<double, 2>& newtonsPerFullScale);

  DeviceLimits GetLimits() const override;
  /**
   * Returns an identity that includes which axes the user has reversed, because their signs differ.
   */
  std::string GetIdentity() const override;

private:
  /** Describes how to drive a device, as found in its descriptor and its names. */
  struct Mapping
  {
    PidDevice Device;
    HidStick Stick;
    PidFirmware Firmware;
    /** Reason why the device gets no forces although it could; empty if it gets forces. */
    std::string Objection;

    /**
     * Reads the mapping from a device's report descriptor. If the descriptor lacks parts that a
     * force-feedback device has, returns false and names them in `error`.
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
  int Repeats = 0; ///< number of consecutive packets that equal the previous one
  std::int64_t LastPacketTime = 0;
  std::int64_t LongestGap = 0; ///< longest gap before a repeated packet (ns)
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
