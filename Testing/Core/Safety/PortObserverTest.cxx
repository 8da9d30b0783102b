// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the observer finds a device that runs away against its force, and raises no false
 * alarm for correct devices. The tests use closed forms, and random sessions of a hand, a device
 * and a wall (PortSessions.h).
 *
 * With a wrong sign, a mass m on a spring k obeys x'' = +(k / m) x, so x = a cosh(w t) with w^2 = k
 * / m. With the right sign, x = v / w sin(w t).
 */

#include "Core/Safety/PortObserver.h"
#include "Rigs/PortSessions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr double Period = 1e-3;
constexpr double Pi = 3.14159265358979323846;

struct Finding
{
  bool IsFound = false;
  double Work = 0.0; ///< J
  double Way = 0.0;  ///< m
};

/// Moves the tip along -X, with a spring that pushes it along +X if x > 0.
template <class Path>
Finding Follow(double stiffness, double duration, const Path& path)
{
  PortObserver observer;
  Finding finding;
  for (int i = 0; i * Period < duration && !finding.IsFound; ++i)
  {
    const double x = path(i * Period);
    finding.IsFound = observer.Observe({ -x, 0.0, 0.0 }, Period);
    observer.RecordSent({ stiffness * std::max(0.0, x), 0.0, 0.0 });
    finding.Work = 0.5 * stiffness * x * x;
    finding.Way = x;
  }
  return finding;
}
} // namespace

TEST(PortObserver, FindsASpringWithAWrongSign)
{
  constexpr double mass = 0.15;
  for (const double k : { 1000.0, 2000.0, 3000.0, 5000.0 })
  {
    const double rate = std::sqrt(k / mass);
    for (const double start : { 1e-4, 5e-4, 1e-3 })
    {
      const Finding finding = Follow(k, 0.2, [&](double t) { return start * std::cosh(rate * t); });
      EXPECT_TRUE(finding.IsFound) << k << " N/m";
      EXPECT_LT(finding.Work, 0.025) << k << " N/m";
      EXPECT_LT(finding.Way, k < 2000.0 ? 0.007 : 0.005) << k << " N/m";
    }
  }
}

TEST(PortObserver, FindsNothingInASpringWithTheRightSign)
{
  for (const double mass : { 0.05, 0.15, 0.5 })
  {
    for (const double k : { 100.0, 1000.0, 5000.0 })
    {
      const double rate = std::sqrt(k / mass);
      // The mass flies into the spring, turns there, and flies out.
      const auto bounce = [&](double t)
      {
        const double phase = rate * (t - 0.02);
        return 0.5 / rate * (phase < 0.0 ? phase : phase > Pi ? Pi - phase : std::sin(phase));
      };
      const Finding finding = Follow(k, 0.3, bounce);
      EXPECT_FALSE(finding.IsFound) << k << " N/m, " << mass << " kg";
    }
  }
}

TEST(PortObserver, FindsNothingInAHandThatIsStrongerThanTheForce)
{
  // Motions that must raise no alarm: at constant speed, with 11.9 m/s^2 from rest, and a rebound
  // at 1 m/s.
  EXPECT_FALSE(Follow(500.0, 0.1, [](double t) { return 1.0 * t; }).IsFound);
  EXPECT_FALSE(Follow(500.0, 0.3, [](double t) { return 0.5 * 11.9 * t * t; }).IsFound);
  EXPECT_FALSE(Follow(500.0, 0.3, [](double t) { return 0.05 - std::fabs(t - 0.1); }).IsFound);
}

TEST(PortObserver, BeginsAnewAfterALeapAndAGap)
{
  PortObserver observer;
  const auto press = [&](double x, double time)
  {
    const bool isFound = observer.Observe({ -x, 0.0, 0.0 }, time);
    observer.RecordSent({ 4.0, 0.0, 0.0 });
    return isFound;
  };
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_FALSE(press(1e-5 * i, Period));
  }
  EXPECT_FALSE(press(0.05, Period)) << "a leap";
  EXPECT_FALSE(press(0.05, Period));
  EXPECT_FALSE(press(0.09, 0.05)) << "a gap";
  EXPECT_FALSE(press(0.0901, Period));
  EXPECT_EQ(observer.GetRunAway(), 0.0);
}

TEST(PortObserver, FindsNoHonestDevice)
{
  for (std::uint32_t seed = 0; seed < 300; ++seed)
  {
    const auto result = rigs::PortSession(rigs::PortKind::Honest, true, 0.0, seed).Run();
    EXPECT_FALSE(result.IsFound) << seed;
  }
}

TEST(PortObserver, FindsDevicesThatRunAwayWithoutAHand)
{
  for (const double k : { 500.0, 1000.0, 5000.0 })
  {
    constexpr int Sessions = 100;
    std::vector<double> given;
    for (std::uint32_t seed = 0; seed < Sessions; ++seed)
    {
      const auto result = rigs::PortSession(rigs::PortKind::WrongSign, false, k, seed).Run();
      given.push_back(result.IsFound ? result.Given : 1.0);
    }
    std::sort(given.begin(), given.end());
    EXPECT_LT(given[Sessions / 2], 0.06) << k << " N/m";
    EXPECT_LT(given[Sessions * 65 / 100], 1.0) << k << " N/m: as many are found";
  }
}

TEST(PortObserver, IsAskedOnlyIfForcesMoveTheTip)
{
  // A recorded path ignores the force, so motion along the force is no sign of a fault.
  for (const bool moves : { false, true })
  {
    SafetyLimits limits;
    limits.MaximumForce = 8.0;
    limits.RampTime = 0.0;
    limits.MovesTip = moves;
    SafetyInput input;
    input.Elapsed = input.Period = Period;
    input.Fresh = true;
    ForceGate gate;
    gate.Arm();
    SafetyStage stage;
    for (int i = 0; i < 50; ++i)
    {
      const double x = 5e-4 * std::cosh(140.0 * i * Period);
      input.Tip = { -x, 0.0, 0.0 };
      input.Force = { 3000.0 * x, 0.0, 0.0 };
      const Vector3 sent = stage.Apply(input, limits, gate);
      EXPECT_TRUE(gate.IsOpen() || Norm(sent) == 0.0);
    }
    EXPECT_EQ(gate.GetFault(), moves ? GateReason::Active : GateReason::None);
    gate.Arm();
    stage.Reset();
    EXPECT_EQ(gate.GetFault(), GateReason::None);
  }
}
