// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a simulated device in a simulated hand moves according to the closed form. */

#include "Devices/Virtual/VirtualDevice.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace VolumeHaptics;

namespace
{
constexpr double Period = 1e-3;

Vector3 Read(VirtualDevice& device)
{
  DeviceSample sample;
  device.Read(Period, sample);
  return sample.Tip;
}

/// Sets the dynamics, and starts at rest at the origin.
void Begin(VirtualDevice& device, const VirtualDynamics& dynamics)
{
  device.SetDynamics(dynamics);
  device.Lead({});
  Read(device);
}
} // namespace

TEST(VirtualDynamics, AMassUnderAForceFollowsTheClosedForm)
{
  VirtualDynamics dynamics;
  dynamics.Mass = 0.1;
  dynamics.Damping = 0.5;
  VirtualDevice device;
  Begin(device, dynamics);
  constexpr double force = 0.3;
  for (int i = 1; i <= 2000; ++i)
  {
    device.Write({ 0.0, force, 0.0 });
    const double t = i * Period;
    const double tau = dynamics.Mass / dynamics.Damping;
    const double exact = force / dynamics.Damping * (t - tau * (1.0 - std::exp(-t / tau)));
    ASSERT_NEAR(Read(device).Y, exact, 1e-10);
  }
}

TEST(VirtualDynamics, TheHandPullsAndTheDampingHoldsAsTheClosedFormSays)
{
  VirtualDynamics dynamics;
  dynamics.Mass = 0.1;
  dynamics.Damping = 1.0;
  dynamics.HandStiffness = 200.0;
  VirtualDevice device;
  Begin(device, dynamics);
  device.Lead({ 0.01, 0.0, 0.0 });
  const double a = dynamics.Damping / (2.0 * dynamics.Mass);
  const double w = std::sqrt(dynamics.HandStiffness / dynamics.Mass - a * a);
  for (int i = 1; i <= 2000; ++i)
  {
    const double t = i * Period;
    const double exact =
      0.01 * (1.0 - std::exp(-a * t) * (std::cos(w * t) + a / w * std::sin(w * t)));
    ASSERT_NEAR(Read(device).X, exact, 1e-10);
  }
}
