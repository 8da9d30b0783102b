// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A force-feedback wheel of one axis, or a stick of two, after the PID 1.0 specification: a pool of
 * effects, of which each plays for its duration by the device's own time.
 *
 * Which way an effect pushes is OpenFFBoard's arithmetic (Ultrawipf/OpenFFBoard, commit 160af910):
 * set_effect() in HidFFB.cpp gives each axis a share,
 *   with Direction Enable: sin(direction) of x, -cos(direction) of y, the direction being the first
 *   angle;
 *   without: (direction x - 180 degrees) / 180 degrees of x and the negative of that of y's own
 *   angle, if the bit of the axis is set;
 * and calcComponentForce() in EffectsCalculator.cpp a torque of -magnitude times that; a positive
 * torque moves an axis towards its positive end (a spring there is -coefficient times position). So
 * a positive magnitude from 90 degrees pushes to the left, because the direction is the side from
 * which the force comes; Linux' hid-pidff.c does the same. An angle is 255 parts of a circle, as in
 * ArduinoJoystickWithFFBLibrary.
 */
#ifndef StickModel_h
#define StickModel_h

#include "DeviceModels.h"
#include "EmulatedHand.h"

#include <atomic>
#include <map>
#include <mutex>

namespace emulated
{

enum class StickFault
{
  None,
  ShortReport,
  Garbage, ///< reports of random places
  Silence,
  WriteError,
  NoBlockLoad,
  FullPool
};

class StickModel : public HidModel
{
public:
  static constexpr double FullScale = 4.0; ///< N, of both axes at a magnitude of 10000
  static constexpr double Travel = 0.05;   ///< m, of the handle at the end of an axis

  /** Without bits that enable its axes, a device goes by the direction alone. */
  explicit StickModel(int axes = 1, bool hasAxisBits = true)
    : Axes(axes)
    , HasAxisBits(hasAxisBits)
  {
  }

  std::uint16_t GetVendor() const override { return 0x1209; }
  std::uint16_t GetProduct() const override { return 0xFFB0; }
  std::string GetName() const override { return this->Axes > 1 ? "FFB Stick" : "FFB Wheel"; }
  std::vector<std::uint8_t> GetReportDescriptor() const override;
  int Output(const std::uint8_t* report, int size) override;
  int SetFeature(const std::uint8_t* report, int size) override;
  int GetFeature(std::uint8_t* report, int size) override;

  /** A millisecond goes by. */
  void Step();
  void PowerUp();
  /** The position (m) to which the hand leads the handle: to the right, and away from itself. */
  void SetGoal(double right, double away);
  Triple GetTip() const;
  /** N on the hand: to the right, and away from it. */
  Triple GetForce() const;
  int CountPlaying() const;
  int CountEffects() const;
  /** The last data under a report id. */
  std::vector<std::uint8_t> GetLast(std::uint8_t id) const;
  int GetResets() const { return this->Resets; }

  std::atomic<StickFault> Fault{ StickFault::None };
  std::atomic<bool> Streams{ false }; ///< it reports all the time, not only what is new
  std::atomic<int> Buttons{ 0 };

private:
  struct Effect
  {
    double Shares[2] = {}; ///< of x and y
    int Duration = 0;
    int Left = 0; ///< ms to play
    int Magnitude = 0;
  };
  Triple Push() const;
  void Report();

  const int Axes;
  const bool HasAxisBits;
  mutable std::mutex Guard;
  EmulatedHand Hand;
  std::map<int, Effect> Effects;
  bool IsEnabled = false;
  int Gain = 0;
  int Loaded = 0; ///< the block that was made last
  int Polls = 0;
  std::vector<std::uint8_t> Sent;
  std::map<std::uint8_t, std::vector<std::uint8_t>> Last;
  std::atomic<int> Resets{ 0 };
  std::uint32_t Noise = 1;
};

} // namespace emulated

#endif
