// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/ForceAugmentation.h"

#include "Core/Safety/UnseenMotion.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Shortest time (s) between two stored measurements. */
constexpr double KeepTime = 0.9e-3;
/** Shortest time (s) over which the velocity is averaged. */
constexpr double VelocityTime = 1.9e-3;
/** A motion of at least this length (m) within NoticeTime (s) is more than a step of an encoder. */
constexpr double NoticeWay = 1e-4;
constexpr double NoticeTime = 4e-3;

} // namespace

void ForceAugmentation::Keep() noexcept
{
  if (this->Count == 0 || this->Time - this->Back(1).Time >= KeepTime)
  {
    this->Measurements[this->Count % Kept] = { this->Time, this->Tip };
    ++this->Count;
  }
}

Vector3 ForceAugmentation::EstimateVelocity() const noexcept
{
  Vector3 velocity;
  const std::size_t kept = std::min(this->Count, Kept);
  for (std::size_t n = 1; n <= kept; ++n)
  {
    const Measurement& first = this->Back(n);
    const double span = this->Time - first.Time;
    if (!(span > 0.0))
    {
      continue;
    }
    const Vector3 slope = (1.0 / span) * (this->Tip - first.Tip);
    for (std::size_t i = 1; span > VelocityTime && i < n; ++i)
    {
      const Measurement& between = this->Back(i);
      const Vector3 line = first.Tip + (between.Time - first.Time) * slope;
      if (Norm(between.Tip - line) > StepSize)
      {
        return velocity;
      }
    }
    velocity = slope;
  }
  return velocity;
}

void ForceAugmentation::Observe(
  const Vector3& tip, double time, double late, double damping) noexcept
{
  const Vector3 motion = tip - this->Tip;
  this->HasMotion = this->HasTip && time > 0.0 && !IsUnseenMotion(motion, time);
  this->Motion = motion;
  this->Tip = tip;
  this->Late = late;
  this->Damping = damping;
  this->HasTip = true;
  this->Rested = 0.0;
  if (!this->HasMotion)
  {
    this->Count = 0;
    this->SentSince = 0;
    this->Velocity = {};
    this->Account = std::min(this->Account, 0.0);
    this->Largest = 0.0;
    this->Keep();
    return;
  }
  this->Between = time;
  this->Time += time;
  this->Velocity = this->EstimateVelocity();
  this->Keep();
}

void ForceAugmentation::Rest(double time) noexcept
{
  this->Rested += time;
  this->Velocity = ClampNorm(this->Velocity, StepSize / this->Rested);
}

/** Returns the energy (J) that the port gave to the hand during the last motion. */
double ForceAugmentation::ComputeGiven(const Vector3& force, double period) const noexcept
{
  const auto before = static_cast<std::size_t>(std::ceil(this->Late / period - 0.01));
  const std::size_t acted =
    std::min({ std::max<std::size_t>(this->SentSince, 1) + before, this->Sent, KeptForces });
  if (acted == 0)
  {
    return 0.0;
  }
  const Vector3& last = this->Forces[(this->Sent - 1) % KeptForces];
  if (NoticeTime * Norm(this->Velocity) <= NoticeWay)
  {
    return 0.5 * Dot(last + force, this->Motion);
  }
  double given = Dot(last, this->Motion);
  for (std::size_t i = 2; i <= acted; ++i)
  {
    given = std::max(given, Dot(this->Forces[(this->Sent - i) % KeptForces], this->Motion));
  }
  return given - this->Damping * Dot(this->Velocity, this->Velocity) * this->Between;
}

void ForceAugmentation::RecordSent(const Vector3& force, double period, double wallWork) noexcept
{
  this->Account += wallWork;
  if (this->HasMotion)
  {
    this->HasMotion = false;
    this->Account -= this->ComputeGiven(force, period);
    this->SentSince = 0;
  }
  this->Forces[this->Sent % KeptForces] = force;
  ++this->Sent;
  ++this->SentSince;
}

/**
 * Solves (2) for the largest force (N). `kept` (J) is the energy that a force `base` (N) may give
 * back.
 */
double ForceAugmentation::ComputeMost(
  double speed, const AugmentationInput& input, double base, double kept) const noexcept
{
  const double time = std::max(this->Between, input.Period) + this->Late;
  const double yield = 0.25 / input.Stiffness + 0.5 * time * time / LightMass;
  const double way = speed * time + yield * base;
  const double root = way * way + 4.0 * yield * (this->Account + Tolerance - kept);
  return base + (root > 0.0 ? std::max(0.0, (std::sqrt(root) - way) / (2.0 * yield)) : 0.0);
}

Vector3 ForceAugmentation::Apply(const AugmentationInput& input) noexcept
{
  const double wall = Norm(input.Wall);
  this->Free = wall > 0.0 ? 0.0 : this->Free + input.Period;
  if (!(wall > 0.0))
  {
    this->Account = this->Free < RestTime ? std::min(this->Account, 0.0) : 0.0;
    this->Largest = 0.0;
    this->IsHeldBack = false;
    return input.Wall;
  }
  const double k = input.Feedback;
  const double ideal = input.Stiffness;
  const double pull = std::max(input.Pull, wall);
  if (!(k > 0.0 && ideal > k))
  {
    return ClampNorm(input.Wall, input.Most);
  }
  this->Largest = std::max(this->Largest, 0.5 * wall * (2.0 * pull - wall) / ideal);
  this->Account = std::min(this->Account, this->Largest);
  const Vector3 out = (1.0 / wall) * input.Wall;
  const double speed = Dot(this->Velocity, out);
  const double late =
    std::max(this->Between, input.Period) + this->Late + 0.5 * std::max(this->Between, 2e-3);
  const double light = 0.5 * LightMass / late;
  const double damping = input.MaximumDamping > 0.0 ? std::min(input.MaximumDamping, light) : light;
  const double soft = k / ideal * pull;
  const double base = std::min(wall, soft);
  const double wanted = std::max(base, wall - input.DampingShare * damping * speed);
  // A spring that did not push with its full force on the way in must not do so on the way out.
  this->IsHeldBack = this->IsHeldBack || base > input.Most;
  const double floor = this->IsHeldBack ? 0.0 : base;
  const double most =
    this->ComputeMost(speed, input, floor, 0.5 * floor * (2.0 * soft - floor) / k);
  return std::min({ wanted, most, input.Most }) * out;
}

} // namespace VolumeHaptics
