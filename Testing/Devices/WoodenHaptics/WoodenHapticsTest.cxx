// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests WoodenHaptics' packets, kinematics and currents.
 */

#include "Devices/WoodenHaptics/WoodenHaptics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr double Right = 1.5707963267948966; // rad
const std::array<double, 3> Rest{ 0.0, 0.0, Right };

Vector3 TipAt(std::int16_t a, std::int16_t b, std::int16_t c)
{
  const WoodenHaptics device;
  return device.ComputeTip(device.ComputeAngles({ a, b, c, 0, 0, 0 }));
}
void ExpectNear(const Vector3& a, const Vector3& b, double tolerance = 1e-12)
{
  EXPECT_LT(Norm(a - b), tolerance) << a.X << " " << a.Y << " " << a.Z;
}
} // namespace

TEST(WoodenHaptics, PacketsAreLittleEndianWords)
{
  const std::array<std::uint8_t, 14> bytes{ 0x01, 0x00, 0xFF, 0xFF, 0x70, 0x17, 0x00, 0x80, 0xFF,
    0x7F, 0x00, 0x00, 0x01, 0x00 };
  WoodenHaptics::Input input;
  EXPECT_EQ(WoodenHaptics::Decode(bytes.data(), bytes.size(), input), nullptr);
  EXPECT_EQ(input.Counts, (std::array<std::int16_t, 6>{ 1, -1, 6000, -32768, 32767, 0 }));
  EXPECT_TRUE(input.WantsCalibration);
  EXPECT_EQ(WoodenHaptics::EncodeCurrents({ 788, -591, 3000 }),
    (WoodenHaptics::Packet{ 0, 0x14, 0x03, 0xB1, 0xFD, 0xB8, 0x0B, 0, 0, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(WoodenHaptics().EncodeCalibration(),
    (WoodenHaptics::Packet{ 0, 0, 0, 0, 0, 0, 0, 0x01, 0, 0, 0, 0, 0, 0x70, 0x17 }));
}

TEST(WoodenHaptics, OtherLengthsAreRefusedWithAReason)
{
  const std::vector<std::uint8_t> bytes(64, 0xFF);
  for (std::size_t size = 0; size <= bytes.size(); ++size)
  {
    WoodenHaptics::Input input;
    const char* reason = WoodenHaptics::Decode(bytes.data(), size, input);
    if (size == 14)
    {
      EXPECT_EQ(reason, nullptr);
      continue;
    }
    ASSERT_NE(reason, nullptr) << size;
    EXPECT_NE(
      std::string(reason).find(size < 14 ? "less than 14" : "more than 14"), std::string::npos);
    EXPECT_EQ(input.Counts, (std::array<std::int16_t, 6>{})) << "as it was";
  }
}

TEST(WoodenHaptics, PosesThatCanBeWorkedOutByHand)
{
  ExpectNear(TipAt(0, 0, 6000), { 0.025, 0.0, 0.205 });      // rest pose: upper arm upright,
                                                             // forearm level
  ExpectNear(TipAt(8000, 0, 6000), { -0.22, 0.245, 0.205 }); // 90 degrees about z
  ExpectNear(TipAt(0, 6000, 6000), { 0.23, 0.0, 0.0 });      // both arms level
  ExpectNear(TipAt(0, 0, 0), { -0.22, 0.0, -0.04 });         // hanging along the upright arm
}

TEST(WoodenHaptics, JacobianIsTheDifferenceQuotient)
{
  const WoodenHaptics device;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-1.5, 1.5);
  constexpr double h = 1e-6;
  for (int i = 0; i < 200; ++i)
  {
    const std::array<double, 3> at{ angle(random), angle(random), angle(random) };
    const Matrix3 columns = Transpose(device.ComputeJacobian(at));
    for (int j = 0; j < 3; ++j)
    {
      std::array<double, 3> above = at;
      std::array<double, 3> below = at;
      above[j] += h;
      below[j] -= h;
      const Vector3 rise = device.ComputeTip(above) - device.ComputeTip(below);
      ExpectNear(columns.Row[j], (0.5 / h) * rise, 1e-9);
    }
  }
}

TEST(WoodenHaptics, CurrentsHoldTheForceAndKeepItsDirection)
{
  const WoodenHaptics device;
  using Currents = WoodenHaptics::Currents;
  // In the rest pose, one motor acts along each axis, with levers of 0.245 m and 0.205 m.
  EXPECT_EQ(device.ComputeCurrents(Rest, { 0.0, 1.0, 0.0 }), (Currents{ 591, 0, 0 }));
  EXPECT_EQ(device.ComputeCurrents(Rest, { 1.0, 0.0, 0.0 }), (Currents{ 0, 660, 0 }));
  EXPECT_EQ(device.ComputeCurrents(Rest, { 0.0, 0.0, -1.0 }), (Currents{ 0, 0, -788 }));
  // Motor C would get 6306 mA and is limited to 3000 mA. Motor A gets 3/8 of that, which preserves
  // the direction of the force.
  EXPECT_EQ(device.ComputeCurrents(Rest, { 0.0, 4.0, 8.0 }), (Currents{ 1125, 0, 3000 }));
  EXPECT_EQ(device.ComputeCurrents(Rest, { 0.0, -4e200, -8e200 }), (Currents{ -1125, 0, -3000 }));
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL })
  {
    EXPECT_EQ(device.ComputeCurrents(Rest, { 1.0, bad, 0.0 }), (Currents{}));
    EXPECT_EQ(device.ComputeCurrents({ bad, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }), (Currents{}));
  }
  WoodenHapticsGeometry geometry;
  geometry.Signs = { -1.0, 1.0, -1.0 };
  geometry.MaximumCurrent = 1000.0; // A, more than a packet can represent
  const WoodenHaptics turned(geometry);
  EXPECT_EQ(turned.ComputeAngles({ 8000, 0, 6000, 0, 0, 0 })[0], -Right);
  EXPECT_EQ(turned.ComputeCurrents(Rest, { 0.0, 400.0, 800.0 }), (Currents{ -12288, 0, -32767 }));
}
