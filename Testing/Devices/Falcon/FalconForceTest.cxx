// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the conversion of forces to motor commands: the published values, and the force's direction
 * at saturation.
 */

#include "FalconWorkspace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace hardwaretest;

static_assert(noexcept(FalconCommandsOf({}, {})), "for the servo");

namespace
{
Matrix3 JacobianAt(const Vector3& position)
{
  Vector3 angles;
  Matrix3 jacobian;
  EXPECT_TRUE(FalconInverse(position, angles));
  EXPECT_TRUE(FalconJacobian(position, angles, jacobian));
  return jacobian;
}

/** Returns the force (N) that motor commands exert: F = J^-T tau, with tau = -command / 1e4. */
Vector3 RealisedForce(const Matrix3& jacobian, const FalconCounts& commands)
{
  const Vector3 torque = -1e-4 * Vector3{ 1.0 * commands[0], 1.0 * commands[1], 1.0 * commands[2] };
  return Inverse(Transpose(jacobian)) * torque;
}
} // namespace

TEST(FalconForce, GivesThePublishedCommands)
{
  const Matrix3 jacobian = JacobianAt({ 0.0, 0.0, 0.125 });
  EXPECT_EQ(FalconCommandsOf(jacobian, { 0.0, 0.0, 8.0 }), (FalconCounts{ -2019, -2019, -2019 }));
  EXPECT_EQ(FalconCommandsOf(jacobian, { 0.0, 0.0, -8.0 }), (FalconCounts{ 2019, 2019, 2019 }));
  const Vector3 aside = FalconTorqueCommands(jacobian, { 8.0, 0.0, 0.0 });
  EXPECT_EQ(std::lround(aside.X), -1431);
  EXPECT_EQ(std::lround(aside.Y), 4848);
  EXPECT_EQ(std::lround(aside.Z), -3417);
}

TEST(FalconForce, ScalesAllThreeTogether)
{
  const Matrix3 jacobian = JacobianAt({ 0.0, 0.0, 0.125 });
  // The largest command is limited to 4096. The other two, -1431 and -3417, are multiplied by the
  // same factor 4096/4848.
  EXPECT_EQ(FalconCommandsOf(jacobian, { 8.0, 0.0, 0.0 }), (FalconCounts{ -1209, 4096, -2887 }));
  EXPECT_EQ(FalconCommandsOf(jacobian, { -8.0, 0.0, 0.0 }), (FalconCounts{ 1209, -4096, 2887 }));
  // Commands truncated to 16 bits would wrap around here.
  EXPECT_EQ(FalconCommandsOf(jacobian, { 1e9, 0.0, 0.0 }), (FalconCounts{ -1209, 4096, -2887 }));
}

TEST(FalconForce, KeepsItsDirectionThroughSaturation)
{
  std::mt19937_64 random(7);
  for (const Vector3& position : SampleWorkspace(0.01))
  {
    const Matrix3 jacobian = JacobianAt(position);
    // Rounding changes each motor's command by at most half a unit. J^-T maps this error to a
    // force.
    const double rounding =
      0.5e-4 * std::sqrt(3.0) * std::sqrt(3.0) * LargestColumn(Inverse(Transpose(jacobian)));
    for (const double size : { 0.5, 4.0, 8.0, 40.0, 1e4, 1e12 })
    {
      const auto draw = [&random] { return static_cast<double>(random() % 2001) / 1000.0 - 1.0; };
      Vector3 direction{ draw(), draw(), draw() };
      direction = (1.0 / (Norm(direction) + 1e-9)) * direction;
      const FalconCounts commands = FalconCommandsOf(jacobian, size * direction);
      for (const std::int16_t command : commands)
      {
        EXPECT_LE(std::abs(command), FalconLargestCommand);
      }
      const Vector3 force = RealisedForce(jacobian, commands);
      EXPECT_LE(Norm(Cross(direction, force)), rounding);
      EXPECT_GT(Dot(direction, force), 0.0);
      EXPECT_LE(Dot(direction, force), size + rounding);
    }
  }
}

TEST(FalconForce, IsAsWantedBelowTheCap)
{
  for (const Vector3& position : SampleWorkspace(0.015))
  {
    const Matrix3 jacobian = JacobianAt(position);
    const Vector3 wanted{ 1.0, -2.0, 0.5 };
    const Vector3 force = RealisedForce(jacobian, FalconCommandsOf(jacobian, wanted));
    EXPECT_LT(Norm(force - wanted), 0.01);
  }
}

TEST(FalconForce, IsNothingWhereItIsNoNumber)
{
  const Matrix3 jacobian = JacobianAt({ 0.0, 0.0, 0.125 });
  for (const double bad : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    EXPECT_EQ(FalconCommandsOf(jacobian, { bad, 0.0, 1.0 }), FalconCounts{});
    EXPECT_EQ(FalconCommandsOf(bad * jacobian, { 1.0, 0.0, 1.0 }), FalconCounts{});
  }
}
