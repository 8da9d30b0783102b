// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/PortDamper.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Shortest time (s) over which the velocity is averaged. In this time, an encoder step of 0.06 mm
 * counts as 30 mm/s.
 */
constexpr double DamperVelocityTime = 2e-3;
/** After this time (s) without a measurement, the tip may have moved unseen. */
constexpr double DamperGapTime = 0.03;

} // namespace

void PortDamper::Reset() noexcept
{
  *this = PortDamper{};
}

void PortDamper::Observe(const Vector3& tip, double time) noexcept
{
  this->Time += time;
  if (this->Count > 0 && time <= DamperGapTime)
  {
    const Vector3& last = this->Measurements[(this->Count - 1) % Kept].Tip;
    this->Taken -= Dot((1.0 / std::max(1.0, this->DampedCount)) * this->DampedSum, tip - last);
    this->Between = time;
  }
  else
  {
    this->Count = 0;
  }
  this->DampedSum = {};
  this->DampedCount = 0.0;
  this->Measurements[this->Count % Kept] = { this->Time, tip };
  ++this->Count;
  this->Velocity = {};
  const std::size_t kept = std::min(this->Count, Kept);
  for (std::size_t before = 1; before < kept; ++before)
  {
    const Measurement& first = this->Measurements[(this->Count - 1 - before) % Kept];
    this->Span = this->Time - first.Time;
    if (this->Span >= DamperVelocityTime * (1.0 - 1e-9))
    {
      this->Velocity = (1.0 / this->Span) * (tip - first.Tip);
      break;
    }
  }
}

Vector3 PortDamper::Apply(const Vector3& wall, double most, double cap, double period) noexcept
{
  const bool pushes = Dot(wall, wall) > 0.0;
  this->Free = pushes ? 0.0 : this->Free + period;
  this->Engaged = this->Engaged && this->Free < RestTime;
  this->DampedCount += 1.0;
  if (!this->Engaged || !pushes || this->Taken < -MostGiven)
  {
    return wall;
  }
  // The longest delay of the damping force is half of the time over which the velocity is measured,
  // plus one tick until the force reaches the hand, and one tick during which the force lasts.
  const double late = 0.5 * this->Span + std::max(this->Between, period) + period;
  const double largest = 0.5 * LightMass / late;
  const double damping = cap > 0.0 ? std::min(cap, largest) : largest;
  const double norm = Norm(wall);
  const double wanted = norm - damping / norm * Dot(this->Velocity, wall);
  const double sent = std::clamp(wanted, 0.0, std::max(most, norm));
  const Vector3 damped = (sent / norm - 1.0) * wall;
  this->DampedSum += damped;
  return wall + damped;
}

} // namespace VolumeHaptics
