// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A board with ArduinoJoystickWithFFBLibrary, written from its published source
 * (YukMingLaw/ArduinoJoystickWithFFBLibrary, version 1.0.0, commit ed86e27).
 *
 * Facts: src/FFBDescriptor.h and the constructor in src/Joystick.cpp (the reports),
 * src/DynamicHID/DynamicHID.cpp and PIDReportHandler.cpp (the blocks and their states),
 * PIDReportType.h (the layout), Joystick.cpp getEffectForce(), forceCalculator() and
 * ApplyEnvelope() (the forces, in the integers of the board); the sketch is
 * examples/SingleJoystickFFB, which sends a report in each turn of its loop. Numbers are those of
 * Arduino's Leonardo, the board that the library names first; its core gives them and the name.
 *
 * A direction is 255 parts of a circle. If Direction Enable is the only bit of the three that is
 * set, both axes go by the first direction, else each by its own. The force is
 *   magnitude sin(direction) of x, -magnitude cos(direction) of y,
 * and the bits of the axes hold nothing back. A force above zero moves an axis towards its positive
 * end: the library's spring is -coefficient times position. So the direction is where the force
 * goes to, the contrary of OpenFFBoard's and of Linux' hid-pidff. An effect's gain falls out of the
 * division in ApplyEnvelope(), and Device Gain is stored and not used.
 */
#ifndef ArduinoFfbModel_h
#define ArduinoFfbModel_h

#include "FfbHandle.h"

namespace emulated
{

class ArduinoFfbModel : public FfbHandle
{
public:
  /** With a motor on x, or on x and y: the descriptor is the same. */
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

  int TakeOutput(const std::uint8_t* report, int size) override;
  int TakeFeature(const std::uint8_t* report, int size) override;
  int GiveFeature(std::uint8_t* report, int size) override;
  void ForgetEffects() override;
  int CountAll(bool onlyPlaying) const override;
  std::array<double, 2> ComputeTorques() const override;
  Bytes BuildReport(double x, double y) const override;
  int GetReminderTime() const override { return 0; }

  int TakeFreeBlock();
  bool Acts(const Effect& effect) const;

  std::array<Effect, MaximumEffects + 1> Effects{}; ///< number 0 is not used
  int NextFree = 1;
  int Loaded = 0;
  int LoadStatus = 0;
  int LoadId = 0; ///< the report's number, which is sent once
  bool IsPaused = false;
};

} // namespace emulated

#endif
