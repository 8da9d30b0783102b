// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ZWidth.h"

#include "Devices/Virtual/VirtualDevice.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Mass = 0.1;     // kg, of the device
constexpr double Period = 0.001; // s, duration of a tick
constexpr double Pull = 2.0;     // N/m, spring of the hand
constexpr int Ticks = 6000;

/**
 * Returns whether the simulated device swings less at the end than in the middle of a long rest on
 * a wall, and never leaves the wall meanwhile. A device that bounces for ever may bounce slightly
 * lower at the end.
 */
bool ComesToRest(const HapticModel& model, double damping, int delay)
{
  VirtualDevice device;
  device.SetDynamics({ Mass, damping, Pull, 0.0, delay, 2.0 });
  device.Lead({ 0.0, 0.0, 0.0 });
  ServoState state;
  TickRecord record;
  double middle = 0.0;
  double end = 0.0;
  double rest = 0.0;
  bool bounces = false;
  for (int i = 0; i < Ticks; ++i)
  {
    DeviceSample sample;
    device.Read(Period, sample);
    // Wait until the slow loop of a local surface has fitted a surface.
    if (i == 50)
    {
      device.Lead({ 0.0, 0.0, 0.02 });
    }
    Tick(model, state, sample.Tip, record);
    device.Write(record.Force);
    bounces = bounces || (i >= Ticks / 2 && Norm(record.Force) == 0.0);
    rest = i < Ticks / 2 ? record.Tip.Z : rest;
    double& swing = i < 3 * Ticks / 4 ? middle : end;
    swing = i >= Ticks / 2 ? std::max(swing, std::abs(record.Tip.Z - rest)) : swing;
  }
  return !bounces && (end < middle || end < 1e-9);
}
} // namespace

double FindStiffestWall(const WallMaker& makeWall, double damping, int delay)
{
  double low = 10.0;
  double high = 6000.0;
  while (high - low > 0.005 * low)
  {
    const double k = std::sqrt(low * high);
    const auto model = makeWall(k);
    (ComesToRest(*model, damping, delay) ? low : high) = k;
  }
  return low;
}

} // namespace evaluation
