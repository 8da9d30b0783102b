// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that damping at the port only takes energy, whatever the hand's motion is.
 */

#include "Core/Safety/PortDamper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace VolumeHaptics;

namespace
{
constexpr double Period = 1e-3;
} // namespace

TEST(PortDamper, LeavesTheForceAsItIsUntilItIsEngaged)
{
  PortDamper damper;
  for (int i = 0; i < 100; ++i)
  {
    damper.Observe({ 1e-4 * i, 0.0, 0.0 }, Period);
    const Vector3 wall{ -0.1 * i, 0.3, 0.7 };
    EXPECT_EQ(Norm(damper.Apply(wall, 8.0, 0.0, Period) - wall), 0.0);
  }
}

TEST(PortDamper, GivesNoEnergyWhateverTheHandDoes)
{
  // The hand swings at random frequencies of up to 60 Hz, and sometimes leaps.
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    std::mt19937 engine(seed);
    const auto pick = [&](double a, double b) { return a + (b - a) * (engine() * 0x1p-32); };
    const int every = 1 + static_cast<int>(engine() % 8);
    const double rate = pick(1.0, 60.0);
    const double size = pick(1e-4, 5e-3);
    const double other = pick(1.0, 60.0);
    PortDamper damper;
    damper.Engage();
    Vector3 tip;
    Vector3 added;
    double given = 0.0;
    double leapt = 0.0;
    double most = 0.0;
    for (int i = 0; i < 3000; ++i)
    {
      leapt += pick(0.0, 1.0) < 0.002 ? pick(-2e-3, 2e-3) : 0.0;
      const double t = 2e-3 * std::acos(-1.0) * i;
      const Vector3 next{ leapt + size * std::sin(rate * t), size * std::cos(other * t), 0.0 };
      given += Dot(added, next - tip);
      // The damper sees the motion only at the next measurement, so its force may give energy
      // during one interval between measurements.
      most = std::max(most, Norm(added) * Norm(next - tip) * every);
      tip = next;
      if (i % every == 0)
      {
        damper.Observe(tip, every * Period);
      }
      const Vector3 wall{ -1.0 - std::sin(0.3 * t), 0.5, 0.0 };
      const Vector3 sent = damper.Apply(wall, 4.0, 0.0, Period);
      EXPECT_LE(Norm(sent), 4.0 + 1e-12);
      EXPECT_GE(Dot(sent, wall), 0.0) << "it never pulls";
      added = sent - wall;
    }
    EXPECT_LE(given, PortDamper::MostGiven + most) << seed;
  }
}

TEST(PortDamper, TakesUpToTheLimitOfTheDevice)
{
  const auto damp = [](double cap)
  {
    PortDamper damper;
    damper.Engage();
    Vector3 sent;
    for (int i = 0; i < 50; ++i)
    {
      damper.Observe({ 0.0, 0.0, 1e-4 * i }, Period);
      sent = damper.Apply({ 0.0, 0.0, 2.0 }, 8.0, cap, Period);
    }
    return 2.0 - sent.Z;
  };
  EXPECT_NEAR(damp(2.0), 0.2, 1e-12) << "0.1 m/s";
  // Without a limit of the device, the damping B is limited by B tau / m = 1/2, where m is the
  // light mass and tau = 3 ms the delay: half of the measurement over 2 ms, a period of 1 ms and a
  // tick of transport.
  EXPECT_NEAR(damp(0.0), 0.1 * 0.5 * PortDamper::LightMass / 3e-3, 1e-9);
  EXPECT_NEAR(damp(1e3), damp(0.0), 1e-12);
}

TEST(PortDamper, EndsOnceTheWallDoesNotPush)
{
  PortDamper damper;
  damper.Engage();
  for (int i = 0; i < 490; ++i)
  {
    damper.Apply({}, 8.0, 0.0, Period);
  }
  EXPECT_TRUE(damper.IsEngaged());
  damper.Apply({ 0.0, 0.0, 1.0 }, 8.0, 0.0, Period);
  for (int i = 0; i < 490; ++i)
  {
    damper.Apply({}, 8.0, 0.0, Period);
  }
  EXPECT_TRUE(damper.IsEngaged()) << "it bounced";
  for (int i = 0; i < 20; ++i)
  {
    damper.Apply({}, 8.0, 0.0, Period);
  }
  EXPECT_FALSE(damper.IsEngaged());
}
