// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the closed loop of a device and the servo's tick becomes unstable at the stiffness
 * that the theory of sampled data predicts (T16).
 */

#include "Devices/Virtual/VirtualDevice.h"
#include "Rigs/CoreScene.h"
#include "SampledLoop.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace coretest;
using namespace servotest;

namespace
{
/// Lets a tip swing on a fixed proxy. Returns the factor by which the amplitude grows over a long
/// run.
double Simulate(double k, int delay)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Describe(volume);
  description.Material.Stiffness = ConstantPolyline(k);
  description.Material.Viscosity = ConstantPolyline(1e12); // holds the proxy in place
  const HapticModel model(description);
  VirtualDevice device;
  device.SetDynamics({ Mass, Damping, 0.0, 0.0, delay, 2.0 });
  ServoState state;
  state.Proxy = { 0.01, 0.01, 0.01 };
  state.Enabled = true;
  device.Lead({ 0.01 + 1e-5, 0.01, 0.01 });
  constexpr int ticks = 60000;
  double first = 0.0;
  double last = 0.0;
  for (int i = 0; i < ticks; ++i)
  {
    DeviceSample sample;
    device.Read(Period, sample);
    TickRecord record;
    Tick(model, state, sample.Tip, record);
    device.Write(record.Force);
    double& swing = i < ticks / 2 ? first : last;
    swing = i % (ticks / 2) < 500 ? std::max(swing, std::abs(sample.Tip.X - 0.01)) : swing;
  }
  return last / first;
}
} // namespace

TEST(Stability, TheLimitsAreThoseOfT16)
{
  EXPECT_NEAR(ComputeLimit(0), 1000.0, 20.0);
  EXPECT_NEAR(ComputeLimit(1), 340.0, 10.0);
}

TEST(Stability, TheSimulatedLoopHasTheseLimits)
{
  for (const int delay : { 0, 1, 2 })
  {
    const double limit = ComputeLimit(delay);
    EXPECT_LT(Simulate(0.97 * limit, delay), 0.8) << "below " << limit << " N/m, delay " << delay;
    EXPECT_GT(Simulate(1.03 * limit, delay), 1.25) << "above " << limit << " N/m, delay " << delay;
  }
}
