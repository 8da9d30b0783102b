// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the arithmetic of the force-feedback firmwares with numbers calculated by hand from the
 * published formulas.
 */
#include "ArduinoFfbModel.h"
#include "OpenFfboardModel.h"

#include <gtest/gtest.h>

using namespace emulated;

namespace
{
using Kind = OpenFfboardModel::Kind;
using Version = OpenFfboardModel::Version;
using Report = std::vector<std::uint8_t>;

void Send(FfbHandle& model, const Report& report)
{
  EXPECT_EQ(
    model.Output(report.data(), static_cast<int>(report.size())), static_cast<int>(report.size()));
}

/// Starts a constant effect of 100 ms in block 1 of the model.
void Play(OpenFfboardModel& model, int bits, int x, int y, int magnitude, int gain)
{
  const Report create{ 0x11, 1, 0, 0 };
  EXPECT_EQ(model.SetFeature(create.data(), 4), 4);
  const auto byte = [](int word) { return static_cast<std::uint8_t>(word & 0xFF); };
  Send(model,
    { 1, 1, 1, 100, 0, 0, 0, 0, 0, 0, 0, byte(gain), 0, byte(bits), byte(x), byte(x >> 8), byte(y),
      byte(y >> 8), 0, 0, 0, 0 });
  Send(model, { 5, 1, byte(magnitude), byte(magnitude >> 8) });
  Send(model, { 10, 1, 1, 1 });
}

void ExpectForce(const FfbHandle& model, double right, double away)
{
  EXPECT_NEAR(model.GetForce()[0], right, 1e-9);
  EXPECT_NEAR(model.GetForce()[1], away, 1e-9);
}
constexpr double Unit = FfbHandle::FullScale / 32767.0; // N
} // namespace

TEST(FfbModels, OpenFfboardPushesAwayFromTheDirectionAndOlderOnesTurnY)
{
  // The force is 20000 * 128 / 255 = 10039, times the sine of 45 degrees = 7098, times 200 / 255 =
  // 5567.
  OpenFfboardModel model(Kind::Joystick);
  Send(model, { 13, 200 });
  Play(model, 4, 4500, 0, 20000, 128);
  ExpectForce(model, -5567 * Unit, -5567 * Unit);
  OpenFfboardModel older(Kind::Joystick, Version::V1_16_0);
  Send(older, { 13, 200 });
  Play(older, 4, 4500, 0, 20000, 128);
  ExpectForce(older, -5567 * Unit, 5567 * Unit);
}

TEST(FfbModels, OpenFfboardWithoutDirectionGoesByShares)
{
  // The fraction of x is (27000 - 18000) / 18000 = 0.5, and that of y is -(9000 - 18000) / 18000 =
  // 0.5.
  OpenFfboardModel model(Kind::Joystick);
  Play(model, 3, 27000, 9000, 20000, 255);
  ExpectForce(model, -10000 * Unit, 10000 * Unit);
  // A wheel built with the one-axis descriptor ignores the bit that this descriptor declares as
  // Direction Enable.
  OpenFfboardModel wheel(Kind::OneAxisWheel);
  Play(wheel, 2, 9000, 0, 20000, 255);
  ExpectForce(wheel, 0.0, 0.0);
  Play(wheel, 1, 36000, 0, 20000, 255);
  EXPECT_EQ(wheel.CountEffects(), 2);
  ExpectForce(wheel, -20000 * Unit, 0.0);
}

TEST(FfbModels, OpenFfboardsEffectsEndAndItsControlsAreBits)
{
  OpenFfboardModel model(Kind::Wheel);
  Play(model, 4, 9000, 0, 20000, 255);
  for (int i = 0; i < 100; ++i)
  {
    model.Step();
  }
  ExpectForce(model, -20000 * Unit, 0.0);
  model.Step();
  ExpectForce(model, 0.0, 0.0);
  Send(model, { 10, 1, 1, 1 });
  ExpectForce(model, -20000 * Unit, 0.0);
  Send(model, { 12, 4 });
  ExpectForce(model, 0.0, 0.0);
  Send(model, { 12, 1 });
  ExpectForce(model, -20000 * Unit, 0.0);
  Send(model, { 12, 8 });
  EXPECT_EQ(model.CountEffects(), 0);
}

TEST(FfbModels, ArduinosLibraryPushesTowardsTheDirection)
{
  ArduinoFfbModel model;
  const Report create{ 5, 1, 0, 0 };
  EXPECT_EQ(model.SetFeature(create.data(), 4), 4);
  const auto play = [&model](std::uint8_t bits, std::uint8_t x, std::uint8_t y, std::uint8_t gain)
  {
    Send(model, { 1, 1, 1, 100, 0, 0, 0, 0, 0, gain, 0, bits, x, y, 0, 0, 0, 0 });
    Send(model, { 5, 1, 0x88, 0x13 }); // 5000
    Send(model, { 10, 1, 1, 1 });
  };
  constexpr double unit = FfbHandle::FullScale / 250.0; // N
  // 64/255 of a circle are 90.35 degrees. Along x, 5000 becomes 4999, which is mapped to 124 of
  // 250. Along y, 30 becomes 0.
  play(4, 64, 0, 255);
  ExpectForce(model, 124 * unit, 0.0);
  play(4, 64, 0, 51);
  ExpectForce(model, 124 * unit, 0.0); // the division loses the effect's gain
  // North is -5000 along HID's y, which pushes away from the user.
  play(4, 0, 0, 255);
  ExpectForce(model, 0.0, 125 * unit);
  // With the bits of both axes, each axis has its own direction. For y, 0 is north.
  play(7, 64, 0, 255);
  ExpectForce(model, 124 * unit, 125 * unit);
  Send(model, { 12, 3 });
  ExpectForce(model, 0.0, 0.0);
}
