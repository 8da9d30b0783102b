// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the Falcon's forward and inverse kinematics and its Jacobian, within its reach and beyond.
 */

#include "FalconWorkspace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace hardwaretest;

static_assert(noexcept(FalconForward({})) && noexcept(FalconAnglesOf({})), "for the servo");

namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

void ExpectPosition(const FalconCounts& counts, const Vector3& expected)
{
  const FalconPose pose = FalconForward(FalconAnglesOf(counts));
  EXPECT_EQ(pose.Reach, FalconReach::Reached);
  EXPECT_LT(Norm(pose.Position - expected), 1e-6);
}
} // namespace

TEST(FalconKinematics, FindsThePublishedPositions)
{
  ExpectPosition({ 0, 0, 0 }, { 0.0, 0.0, 0.134602 });
  ExpectPosition({ 500, 500, 500 }, { 0.0, 0.0, 0.156860 });
  ExpectPosition({ -500, -500, -500 }, { 0.0, 0.0, 0.110754 });
  ExpectPosition({ 300, 0, -300 }, { -0.004118, -0.021653, 0.132316 });
}

TEST(FalconKinematics, CountsAreAngles)
{
  const Vector3 angles = FalconAnglesOf({ 0, 1000, -1000 });
  EXPECT_NEAR(angles.X, 35.0 * Degree, 1e-12);
  EXPECT_NEAR(angles.Y, 71.4347 * Degree, 1e-12);
  EXPECT_NEAR(angles.Z, -1.4347 * Degree, 1e-12);
}

TEST(FalconKinematics, ForwardUndoesInverseInTheWholeWorkspace)
{
  int most = 0;
  for (const Vector3& position : SampleWorkspace())
  {
    Vector3 angles;
    ASSERT_TRUE(FalconInverse(position, angles));
    const FalconPose pose = FalconForward(angles);
    ASSERT_EQ(pose.Reach, FalconReach::Reached)
      << position.X << ' ' << position.Y << ' ' << position.Z;
    EXPECT_LT(Norm(pose.Position - position), 1e-9);
    most = std::max(most, pose.Steps);
  }
  EXPECT_LE(most, 8);
}

TEST(FalconKinematics, JacobianIsTheForwardsDerivative)
{
  constexpr double h = 1e-6;
  for (const Vector3& position : SampleWorkspace(0.015))
  {
    Vector3 angles;
    ASSERT_TRUE(FalconInverse(position, angles));
    Matrix3 jacobian;
    ASSERT_TRUE(FalconJacobian(position, angles, jacobian));
    for (int row = 0; row < 3; ++row)
    {
      EXPECT_LT(Norm(FalconForward(angles).Jacobian.Row[row] - jacobian.Row[row]), 1e-9);
    }
    for (const Vector3& leg : { Vector3{ h, 0, 0 }, Vector3{ 0, h, 0 }, Vector3{ 0, 0, h } })
    {
      const Vector3 change =
        FalconForward(angles + leg).Position - FalconForward(angles - leg).Position;
      EXPECT_LT(Norm((0.5 / h) * (change - 2.0 * (jacobian * leg))), 1e-7);
    }
  }
}

TEST(FalconKinematics, SaysWhatIsOutOfReach)
{
  Vector3 angles{ 1.0, 2.0, 3.0 };
  for (const Vector3& position : { Vector3{ 0.0, 0.0, 0.25 }, Vector3{ 0.0, 0.0, 0.02 },
         Vector3{ 0.2, 0.0, 0.12 }, Vector3{ 0.0, std::nan(""), 0.12 } })
  {
    EXPECT_FALSE(FalconInverse(position, angles));
    EXPECT_EQ(angles.Z, 3.0);
  }
  Matrix3 jacobian;
  EXPECT_FALSE(FalconJacobian({ 0.2, 0.0, 0.12 }, {}, jacobian));
  for (const FalconCounts& counts : { FalconCounts{ 32767, 32767, 32767 },
         FalconCounts{ -32768, 0, 0 }, FalconCounts{ 3000, 3000, 3000 } })
  {
    EXPECT_EQ(FalconForward(FalconAnglesOf(counts)).Reach, FalconReach::OutOfReach);
  }
  for (const double bad : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    EXPECT_EQ(FalconForward({ 0.6, bad, 0.6 }).Reach, FalconReach::OutOfReach);
  }
}

TEST(FalconKinematics, WhateverIsReachedClosesAllLegs)
{
  std::mt19937 random(3);
  int reached = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const auto draw = [&random] { return static_cast<std::int16_t>(random() % 8000) - 4000; };
    const Vector3 angles = FalconAnglesOf({ static_cast<std::int16_t>(draw()),
      static_cast<std::int16_t>(draw()), static_cast<std::int16_t>(draw()) });
    const FalconPose pose = FalconForward(angles);
    EXPECT_TRUE(IsFinite(pose.Position));
    EXPECT_LE(pose.Steps, FalconMostSteps + 1);
    Vector3 again;
    if (pose.Reach == FalconReach::Reached)
    {
      ++reached;
      EXPECT_TRUE(FalconInverse(pose.Position, again));
      EXPECT_LT(Norm(again - angles), 1e-7);
    }
  }
  EXPECT_GT(reached, 500);
}
