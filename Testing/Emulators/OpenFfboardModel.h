// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * OpenFFBoard's firmware, written from its published source (Ultrawipf/OpenFFBoard).
 *
 * Facts of version 1.17.1, commit 160af910, in the folder Firmware/FFBoard:
 * - UserExtensions/Inc/usb_hid_ffb_desc.h, Src/usb_hid_1ffb_desc.c and usb_hid_2ffb_desc.c: the
 *   reports, with a vendor's fields of 64 bits, and with two bits of the range 0 to 0 in the
 *   descriptor of one axis;
 * - UserExtensions/Src/FFBWheel.cpp and FFBJoystick.cpp: a wheel has the descriptor of two axes,
 *   too, unless it was built with FFBWHEEL_USE_1AXIS_DESC. In both cases, it reads bit 2 as
 *   Direction Enable, although the descriptor of one axis says bit 1;
 * - UserExtensions/Src/usb_descriptors.cpp: names and numbers. Since version 1.16.5, the board's
 *   name follows "FFBoard ";
 * - Src/HidFFB.cpp: the effects of the reports; Src/EffectsCalculator.cpp: their torques;
 * - UserExtensions/Src/FFBHIDMain.cpp: a report is sent when something is new, or after 100 ms.
 *
 * With Direction Enable, the fraction of an effect is sin(direction) along x and -cos(direction)
 * along y. The torque is -magnitude times this fraction. A positive torque moves an axis towards
 * its positive end (the torque of a spring is -coefficient times position). Without Direction
 * Enable, and with the axis' bit, the fraction is (direction - 18000) / 18000 along x, and the
 * negative of this, with y's own direction, along y.
 *
 * The previous version, 1.16.0 (HidFFB.cpp of commit 92c62ee8), uses cos(direction) for y, which
 * pushes y in the opposite direction, as in all versions since 1.10.0 (commit 6ae9fac1). Older
 * versions push y like 1.17.1.
 */
#ifndef OpenFfboardModel_h
#define OpenFfboardModel_h

#include "FfbHandle.h"
#include "HidItems.h"

namespace emulated
{

class OpenFfboardModel : public FfbHandle
{
public:
  enum class Kind : std::uint8_t
  {
    Wheel,        ///< one motor and the two-axis descriptor, as published
    OneAxisWheel, ///< one motor and the one-axis descriptor
    Joystick      ///< two motors and the two-axis descriptor
  };
  enum class Version : std::uint8_t
  {
    V1_16_0,
    V1_17_1
  };

  explicit OpenFfboardModel(Kind kind = Kind::Wheel, Version version = Version::V1_17_1)
    : FfbHandle(kind == Kind::Joystick ? 2 : 1)
    , Model(kind)
    , Release(version)
  {
  }

  std::uint16_t GetVendor() const override { return 0x1209; }
  std::uint16_t GetProduct() const override { return 0xFFB0; }
  std::string GetName() const override
  {
    return this->Release == Version::V1_17_1 ? "FFBoard F407VG" : "FFBoard";
  }
  std::vector<std::uint8_t> GetReportDescriptor() const override;

  /** An analogue input of a wheel (-1 to 1), which is reported as the second axis. */
  std::atomic<double> Pedal{ 0.0 };

private:
  static constexpr int MaximumEffects = 40;
  static constexpr int Infinite = 0xFFFF; ///< ms

  struct Effect
  {
    int Type = 0; ///< 0: unused
    bool IsActive = false;
    int Magnitude = 0;
    int Gain = 255;
    double Shares[2] = {};
    int Duration = Infinite;
    int Delay = 0;
    int Start = 0;
  };

  int ReceiveOutput(const std::uint8_t* report, int size) override;
  int ReceiveFeature(const std::uint8_t* report, int size) override;
  int GiveFeature(std::uint8_t* report, int size) override;
  void ForgetEffects() override;
  int CountAll(bool onlyPlaying) const override;
  std::array<double, 2> ComputeTorques() const override;
  Bytes BuildReport(double x, double y) const override;
  int GetReminderTime() const override { return 100; }

  bool HasTwoDirections() const
  {
    return this->Model != Kind::OneAxisWheel && this->Release == Version::V1_17_1;
  }
  bool IsPlaying(const Effect& effect) const;
  void SetEffect(const std::uint8_t* report, int size);
  void Control(int bits);
  void SendStatus();
  void DescribeSetEffect(HidItems& items) const;
  void DescribeCondition(HidItems& items) const;

  const Kind Model;
  const Version Release;
  std::array<Effect, MaximumEffects> Effects{};
  bool IsActive = false;
  int Gain = 255;
  int Loaded = 1;
  int LoadStatus = 1;
};

} // namespace emulated

#endif
