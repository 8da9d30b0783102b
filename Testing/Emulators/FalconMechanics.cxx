// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FalconMechanics.h"

#include <algorithm>
#include <cmath>

namespace emulated
{
namespace
{

constexpr double Degrees = 180.0 / 3.14159265358979323846;
constexpr double Azimuths[3] = { 105.0, -15.0, -135.0 };

} // namespace

Numbers FalconArmAngles(const Numbers& grip)
{
  constexpr double a = 0.060;
  constexpr double b = 0.1025;
  constexpr double c = 0.01443;
  constexpr double d = 0.01125;
  constexpr double e = 0.01125;
  constexpr double f = -0.025;
  constexpr double r = 0.040;
  constexpr double s = -0.02309;
  Numbers angles{};
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    const double phi = Azimuths[leg] / Degrees;
    const double u = std::cos(phi) * grip[0] + std::sin(phi) * grip[1] - r;
    const double v = -std::sin(phi) * grip[0] + std::cos(phi) * grip[1] - s;
    const double w = grip[2];
    const double length = d + e + b * std::sin(std::acos((v + f) / b));
    const double l0 = (u + c - a) * (u + c - a) + w * w - length * length;
    const double l1 = -4.0 * a * w;
    const double l2 = (u + c + a) * (u + c + a) + w * w - length * length;
    const double t = (-l1 - std::sqrt(l1 * l1 - 4.0 * l0 * l2)) / (2.0 * l2);
    angles[leg] = 2.0 * std::atan(t) * Degrees;
  }
  return angles;
}

Numbers FalconEncoderCounts(const Numbers& grip)
{
  Numbers counts = FalconArmAngles(grip);
  for (double& count : counts)
  {
    count = (count - 35.0) / 0.0364347;
  }
  return counts;
}

Numbers FalconMotorForce(const Numbers& grip, const Numbers& commands)
{
  constexpr double step = 1e-6; // m
  Numbers force{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Numbers ahead = grip;
    Numbers behind = grip;
    ahead[axis] += step;
    behind[axis] -= step;
    const Numbers after = FalconArmAngles(ahead);
    const Numbers before = FalconArmAngles(behind);
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      // The work of the motors equals the work of the force: tau dtheta = F dp.
      const double slope = (after[leg] - before[leg]) / Degrees / (2.0 * step);
      force[axis] += -1e-4 * commands[leg] * slope;
    }
  }
  return force;
}

void FalconGrip::Step(const Numbers& force)
{
  constexpr int steps = 4;
  constexpr double time = 1e-3 / steps;
  double distance = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    distance = std::hypot(distance, this->Aim[axis] - this->Hand[axis]);
  }
  const double part = std::min(1.0, HandSpeed * 1e-3 / (distance + 1e-12));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Hand[axis] += part * (this->Aim[axis] - this->Hand[axis]);
    double& place = this->Place[axis];
    double& velocity = this->Velocity[axis];
    place = this->IsHeld ? this->Hand[axis] : place;
    velocity = this->IsHeld ? 0.0 : velocity;
    for (int i = 0; i < steps && !this->IsHeld; ++i)
    {
      const double hand = HandStiffness * (this->Hand[axis] - place) - HandDamping * velocity;
      velocity += time * (hand + force[axis]) / Mass;
      place += time * velocity;
    }
    const double low = axis == 2 ? Innermost : -0.055;
    const double high = axis == 2 ? Outermost : 0.055;
    const bool isOnStop = place < low || place > high;
    place = std::clamp(place, low, high);
    velocity = isOnStop ? 0.0 : velocity;
  }
}

} // namespace emulated
