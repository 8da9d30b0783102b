// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/SafetyStage.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Within which a stale force goes to zero (s). */
constexpr double RetreatTime = 0.02;

/** Nothing passes a limit that is not positive, NaN included. */
Vector3 ClampNorm(const Vector3& v, double most) noexcept
{
  if (!(most > 0.0))
  {
    return {};
  }
  const double norm = Norm(v);
  return norm > most ? (most / norm) * v : v;
}

/**
 * The energy (J) that the spring of an input gives back while it relaxes, if it is felt with no
 * more than `most` (N) of its pull. The pull goes by the stretch: the force may be clamped already.
 * Negative if the stiffness is not known.
 */
double FindRecoverable(const SafetyInput& input, double most) noexcept
{
  const double k = input.Stiffness;
  const double pull = std::max(Norm(input.Force), k * input.Stretch);
  return k > 0.0 ? 0.5 * most * (2.0 * pull - most) / k : -1.0;
}

} // namespace

void SafetyStage::Arm() noexcept
{
  this->Armed = true;
  this->Fault = SafetyFault::None;
  this->HasTip = false;
  this->Cut();
}

Vector3 SafetyStage::Cut() noexcept
{
  this->Growth.Reset();
  this->Ramp = 0.0;
  this->Retreats = false;
  return {};
}

Vector3 SafetyStage::Retreat(const SafetyInput& input, const SafetyLimits& limits) noexcept
{
  // A force without fresh samples must be gone in time, however slowly forces may grow.
  const double rate = std::max(limits.MaximumForceRate, limits.MaximumForce / RetreatTime);
  const Vector3 last = ClampNorm(this->Growth.GetForce(), limits.MaximumForce);
  Vector3 next = last - ClampNorm(last, rate * input.Period);
  if (input.Fresh)
  {
    // It is known again where the hand is: it gets no push that is not wanted there.
    const double norm = Norm(last);
    next = ClampNorm(next, norm > 0.0 ? input.Residency * Dot(input.Force, last) / norm : 0.0);
  }
  this->Growth.Override(next);
  this->Retreats = this->Stale || Dot(next, next) > 0.0;
  return next;
}

double SafetyStage::MeasureSpeed(const SafetyInput& input) noexcept
{
  // A wake-up on time after a late one comes early: the device has moved for a whole period.
  const double time = std::max(this->SampleAge, input.Period);
  const double speed = this->HasTip && time > 0.0 ? Norm(input.Tip - this->LastTip) / time : 0.0;
  this->LastTip = input.Tip;
  this->HasTip = true;
  return speed;
}

Vector3 SafetyStage::Apply(const SafetyInput& input, const SafetyLimits& limits) noexcept
{
  this->SampleAge += input.Elapsed;
  const bool finite = IsFinite(input.Force) && IsFinite(input.Tip);
  double speed = 0.0;
  // A gap counts even where the sample that ends it is fresh: nobody watched the hand meanwhile.
  this->Stale = this->SampleAge > limits.WatchdogTime;
  const bool gap = this->Stale;
  if (input.Fresh && finite)
  {
    speed = this->MeasureSpeed(input);
    this->SampleAge = 0.0;
    this->Stale = false;
  }
  if (this->Armed && this->Fault == SafetyFault::None)
  {
    const bool tooFast = limits.MaximumSpeed > 0.0 && speed > limits.MaximumSpeed;
    this->Fault = input.Lost ? SafetyFault::DeviceLost
      : !finite              ? SafetyFault::NotFinite
      : tooFast              ? SafetyFault::OverSpeed
                             : SafetyFault::None;
  }
  if (!this->Armed || this->Fault != SafetyFault::None)
  {
    return this->Cut();
  }

  if (input.Elapsed > limits.WatchdogTime)
  {
    // The loop itself stood still: what was felt before is not what is there now.
    this->Growth.Reset();
  }
  if (gap)
  {
    this->Ramp = 0.0;
    const Vector3& last = this->Growth.GetForce();
    this->Retreats = this->Stale || Dot(last, last) > 0.0;
  }
  if (this->Retreats)
  {
    return this->Retreat(input, limits);
  }

  const double share = input.Residency * this->Ramp;
  const Vector3 clamped = ClampNorm(input.Force, limits.MaximumForce);
  const double norm = Norm(input.Force);
  const double kept = norm > 0.0 ? share * Norm(clamped) / norm : 0.0;
  const double step = limits.RampTime > 0.0 ? input.Period / limits.RampTime : 1.0;
  this->Ramp = std::min(1.0, this->Ramp + step);
  return this->Growth.Apply(share * clamped, input.Tip, limits.MaximumForceRate * input.Period,
    share * FindRecoverable(input, Norm(clamped)), kept * input.Drag);
}

void SaturateTogether(double* commands, int count, double limit) noexcept
{
  double largest = 0.0;
  bool sound = limit >= 0.0;
  for (int i = 0; i < count; ++i)
  {
    largest = std::max(largest, std::abs(commands[i]));
    sound = sound && std::isfinite(commands[i]);
  }
  if (!sound)
  {
    std::fill(commands, commands + count, 0.0);
  }
  else if (largest > limit)
  {
    for (int i = 0; i < count; ++i)
    {
      commands[i] *= limit / largest;
    }
  }
}

} // namespace VolumeHaptics
