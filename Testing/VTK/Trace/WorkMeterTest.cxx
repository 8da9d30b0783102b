// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the work on the hand (the array Energy of traces) against closed forms of mechanics: the
 * integral of F dx for constant forces, springs and closed paths, and the integral of the torque
 * over a rotation.
 */

#include "VTK/Trace/TraceRow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using VolumeHaptics::Quaternion;
using VolumeHaptics::TickRecord;
using VolumeHaptics::Vector3;
using VolumeHaptics::WorkMeter;

namespace
{

constexpr double FullTurn = 6.28318530717958647693;

TickRecord MakeRecord(const Vector3& tip, const Vector3& force)
{
  TickRecord record;
  record.Tip = tip;
  record.Force = force;
  return record;
}

/// Returns the unit quaternion of a rotation about z by this angle (rad).
Quaternion TurnAboutZ(double angle)
{
  return { std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle) };
}

TickRecord MakeTurn(double angle, const Vector3& torque)
{
  TickRecord record;
  record.Torque = torque;
  record.HandOrientation = TurnAboutZ(angle);
  return record;
}

} // namespace

TEST(WorkMeter, OfAConstantForceIsForceTimesWay)
{
  WorkMeter meter;
  EXPECT_EQ(meter.Add(MakeRecord({ 0.1, 0.2, 0.3 }, { 1.0, -2.0, 0.5 })), 0.0) << "no way yet";
  EXPECT_NEAR(meter.Add(MakeRecord({ 0.3, 0.2, 0.2 }, { 1.0, -2.0, 0.5 })), 0.2 - 0.05, 1e-15);
  EXPECT_NEAR(meter.Add(MakeRecord({ 0.3, 0.6, 0.2 }, { 1.0, -2.0, 0.5 })), 0.15 - 0.8, 1e-15);
  EXPECT_NEAR(meter.Add(MakeRecord({ 0.3, 0.6, 0.2 }, { 9.0, 9.0, 9.0 })), 0.15 - 0.8, 1e-15)
    << "a force that rises at rest does no work";
}

/// A spring of stiffness k absorbs the work k/2 (x2^2 - x1^2) from the hand, in steps of any
/// length.
TEST(WorkMeter, OfASpringIsItsPotential)
{
  constexpr double k = 800.0;
  WorkMeter meter;
  double work = 0.0;
  for (const double x : { 0.001, 0.0012, 0.003, 0.0029, 0.007 })
  {
    work = meter.Add(MakeRecord({ x, 0.0, 0.0 }, { -k * x, 0.0, 0.0 }));
  }
  EXPECT_NEAR(work, -0.5 * k * (0.007 * 0.007 - 0.001 * 0.001), 1e-15);
}

/// Around a circle of radius r, a friction force f absorbs the work 2 pi r f; a central spring
/// absorbs none.
TEST(WorkMeter, AroundACircleIsThatOfFriction)
{
  constexpr int steps = 4000;
  constexpr double r = 0.02;
  constexpr double f = 0.3;
  WorkMeter friction;
  WorkMeter spring;
  double byFriction = 0.0;
  double bySpring = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double angle = FullTurn * i / steps;
    const Vector3 out{ std::cos(angle), std::sin(angle), 0.0 };
    const Vector3 along{ -out.Y, out.X, 0.0 };
    byFriction = friction.Add(MakeRecord(r * out, -f * along));
    bySpring = spring.Add(MakeRecord(r * out, -500.0 * r * out));
  }
  // The chord of a step of angle a = 2 pi/4000 is shorter than its arc by the fraction (a/2)^2/6,
  // and the mean of the two forces is smaller by (a/2)^2/2. Both together are 4e-7.
  EXPECT_NEAR(byFriction, -FullTurn * r * f, FullTurn * r * f * 2e-6);
  EXPECT_NEAR(bySpring, 0.0, 1e-15);
}

/// Over any number of turns, the work of a constant torque is torque times angle.
TEST(WorkMeter, OfATorqueIsTorqueTimesAngle)
{
  constexpr double torque = 0.02;
  WorkMeter meter;
  double work = 0.0;
  for (int i = 0; i <= 100; ++i)
  {
    // A torque perpendicular to the rotation axis does no work.
    work = meter.Add(MakeTurn(0.09 * i, { 0.5, 0.1, torque }));
  }
  EXPECT_NEAR(work, torque * 9.0, 1e-14);
  for (int i = 99; i >= 0; --i)
  {
    work = meter.Add(MakeTurn(0.09 * i, { 0.5, 0.1, torque }));
  }
  EXPECT_NEAR(work, 0.0, 1e-14) << "there and back";
}

/// q and -q are the same orientation. A torsion spring has the potential kappa/2 angle^2.
TEST(WorkMeter, OfATorsionSpringIsItsPotentialWhateverTheSignOfQuaternions)
{
  constexpr double kappa = 0.05;
  WorkMeter meter;
  double work = 0.0;
  for (int i = 0; i <= 20; ++i)
  {
    const double angle = 0.1 * i;
    TickRecord record = MakeTurn(angle, { 0.0, 0.0, -kappa * angle });
    if (i % 2 == 1)
    {
      const Quaternion q = record.HandOrientation;
      record.HandOrientation = { -q.W, -q.X, -q.Y, -q.Z };
    }
    work = meter.Add(record);
  }
  EXPECT_NEAR(work, -0.5 * kappa * 4.0, 1e-14);
}

/// An unmeasured position does no work. The next motion between measured positions counts again.
TEST(WorkMeter, LeavesOutWhatIsNotMeasured)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WorkMeter meter;
  meter.Add(MakeRecord({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }));
  EXPECT_EQ(meter.Add(MakeRecord({ nan, 0.0, 0.0 }, { 1.0, 0.0, 0.0 })), 0.0);
  EXPECT_EQ(meter.Add(MakeRecord({ 2.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 })), 0.0)
    << "from an unknown place";
  EXPECT_EQ(meter.Add(MakeRecord({ 2.5, 0.0, 0.0 }, { 1.0, 0.0, 0.0 })), 0.5);

  WorkMeter turns;
  TickRecord none = MakeTurn(0.0, { 0.0, 0.0, 1.0 });
  none.HandOrientation = VolumeHaptics::NoOrientation;
  turns.Add(MakeTurn(0.0, { 0.0, 0.0, 1.0 }));
  EXPECT_EQ(turns.Add(none), 0.0) << "no tool in the hand";
  EXPECT_EQ(turns.Add(MakeTurn(1.0, { 0.0, 0.0, 1.0 })), 0.0);
  EXPECT_NEAR(turns.Add(MakeTurn(1.5, { 0.0, 0.0, 1.0 })), 0.5, 1e-15);
}
