// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/PadState.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double StickDeadZone = 0.12;
constexpr double TriggerDeadZone = 0.05;
constexpr double LargestDeadZone = 0.5;
constexpr double FineFraction = 0.2;

/** Returns the part of a number (0 to 1) beyond a dead zone, scaled to 0 to 1. */
double Beyond(double part, double deadZone) noexcept
{
  return std::clamp((part - deadZone) / (1.0 - deadZone), 0.0, 1.0);
}

} // namespace

PadMotion Steer(const PadState& state) noexcept
{
  PadMotion motion;
  if ((state.Buttons & PadRightShoulder) != 0)
  {
    return motion;
  }
  const double speed = (state.Buttons & PadLeftShoulder) != 0 ? FineFraction : 1.0;
  const double back = std::clamp(state.RightY + state.LeftTrigger - state.RightTrigger, -1.0, 1.0);
  // A stick reaches farther diagonally than along its axes, so limit the length.
  motion.Push = speed * ClampNorm({ state.LeftX, -state.LeftY, back }, 1.0);
  motion.Turn = { 0.0, speed * state.RightX, 0.0 };
  return motion;
}

double ScaleStick(int value, int least, int most, int flat) noexcept
{
  const double half = 0.5 * (static_cast<double>(most) - static_cast<double>(least));
  if (half <= 0.0)
  {
    return 0.0;
  }
  const double off = (static_cast<double>(value) - static_cast<double>(least) - half) / half;
  const double deadZone = std::clamp(flat / half, StickDeadZone, LargestDeadZone);
  return std::copysign(Beyond(std::abs(off), deadZone), off);
}

double ScaleTrigger(int value, int least, int most, int flat) noexcept
{
  const double range = static_cast<double>(most) - static_cast<double>(least);
  if (range <= 0.0)
  {
    return 0.0;
  }
  const double part = (static_cast<double>(value) - static_cast<double>(least)) / range;
  return Beyond(part, std::clamp(flat / range, TriggerDeadZone, LargestDeadZone));
}

} // namespace VolumeHaptics
