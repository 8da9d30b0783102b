// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A board with ArduinoJoystickWithFFBLibrary, written from its published source
 * (YukMingLaw/ArduinoJoystickWithFFBLibrary, version 1.0.0, commit ed86e27):
 * - src/FFBDescriptor.h and the constructor in src/Joystick.cpp: the reports;
 * - src/DynamicHID/DynamicHID.cpp and PIDReportHandler.cpp: the blocks and their states;
 * - PIDReportType.h: the layout;
 * - getEffectForce(), forceCalculator() and ApplyEnvelope() in Joystick.cpp: the forces, in the
 *   integers of the board;
 * - examples/SingleJoystickFFB: the sketch, which sends a report in each turn of its loop.
 * Vendor and product numbers and the name are those of Arduino's Leonardo, the board that the
 * library names first.
 *
 * A direction is given in 255ths of a circle. If only Direction Enable is set of the three bits,
 * both axes use the first direction; otherwise, each axis has its own direction. The force is
 *
 *   magnitude sin(direction) along x, -magnitude cos(direction) along y,
 *
 * for any bits of the axes. A positive force moves an axis towards its positive end: the library's
 * spring is -coefficient times position. The force thus acts in the direction, contrary to
 * OpenFFBoard and to Linux' hid-pidff. The division in ApplyEnvelope() loses an effect's gain.
 * Device Gain is stored but not used.
 */
#ifndef ArduinoFfbModel_h
#define ArduinoFfbModel_h

#include "FfbHandle.h"

namespace emulated
{

class ArduinoFfbModel : public FfbHandle
{
public:
  /** @param motors 1: a motor on x; 2: motors on x and y. The descriptor is the same. */
  explicit ArduinoFfbModel(int motors = 2)
    : FfbHandle(motors)
  {
  }

  std::uint16_t GetVendor() const override { return 0x2341; }
  std::uint16_t GetProduct() const override { return 0x8036; }
  std::string GetName() const override { return "Arduino Leonardo"; }
  std::vector<std::uint8_t> GetReportDescriptor() const override;

private:
  static constexpr int MaximumEffects = 14;

  struct Effect
  {
    bool IsAllocated = false;
    bool IsPlaying = false;
    int Type = 0;
    int Magnitude = 0;
    int Gain = 0;
    int Bits = 0;
    int Directions[2] = {};
    int Duration = 0;
    int Start = 0;
  };

  int ReceiveOutput(const std::uint8_t* report, int size) override;
  int ReceiveFeature(const std::uint8_t* report, int size) override;
  int GiveFeature(std::uint8_t* report, int size) override;
  void ForgetEffects() override;
  int CountAll(bool onlyPlaying) const override;
  std::array<double, 2> ComputeTorques() const override;
  Bytes BuildReport(double x, double y) const override;
  int GetReminderTime() const override { return 0; }

  int ClaimFreeBlock();
  bool Acts(const Effect& effect) const;

  std::array<Effect, MaximumEffects + 1> Effects{}; ///< element 0 is unused
  int NextFree = 1;
  int Loaded = 0;
  int LoadStatus = 0;
  int LoadId = 0; ///< id of a report that is sent only once
  bool IsPaused = false;
};

} // namespace emulated

#endif
