// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/Vibration.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Limit of a force (N) that prevents overflows in sums. It is larger than any force that is sent.
 */
constexpr double LargestForce = 1e6;

/** Moves a level towards `wanted`, at a limited rate. */
double Compute(double level, double wanted, double elapsed) noexcept
{
  return std::clamp(
    wanted, level - Vibration::FallRate * elapsed, level + Vibration::RiseRate * elapsed);
}

} // namespace

VibrationLevels Vibration::Advance(const Vector3& force, double elapsed) noexcept
{
  if (!(Norm(force) <= LargestForce)) // true for NaN, too
  {
    this->Silence();
    return this->Levels;
  }
  // This formula is exact for a constant force, however long the elapsed time is.
  this->Fast += -std::expm1(-elapsed / FastTime) * (force - this->Fast);
  this->Slow += -std::expm1(-elapsed / SlowTime) * (force - this->Slow);
  const double weak = std::min(1.0, Norm(force - this->Fast) / FullChange);
  const double strong = std::min(1.0, Norm(this->Fast - this->Slow) / FullChange);
  this->Levels.Weak = Compute(this->Levels.Weak, weak, elapsed);
  this->Levels.Strong = Compute(this->Levels.Strong, strong, elapsed);
  return this->Levels;
}

void Vibration::Silence() noexcept
{
  *this = {};
}

int Vibration::Quantize(double level, int steps) noexcept
{
  return level < Least ? 0 : static_cast<int>(std::lround(std::min(1.0, level) * steps));
}

} // namespace VolumeHaptics
