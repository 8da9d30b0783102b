// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SafetyStage.h"

#include "Residency.h"

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

} // namespace

void SafetyStage::Arm() noexcept
{
  this->Armed = true;
  this->Fault = SafetyFault::None;
  this->Ramp = 0.0;
  this->Last = {};
  this->HasTip = false;
}

Vector3 SafetyStage::Cut() noexcept
{
  this->Last = {};
  this->Ramp = 0.0;
  return {};
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

  if (gap)
  {
    this->Ramp = 0.0;
  }
  if (input.Elapsed > limits.WatchdogTime)
  {
    // The loop itself stood still: what was felt before is not what is there now.
    this->Last = {};
  }
  const Vector3 wanted = this->Stale
    ? Vector3{}
    : input.Residency * this->Ramp * ClampNorm(input.Force, limits.MaximumForce);
  // However slow forces may change, one that nobody controls any more is gone in time.
  const double least = this->Stale ? limits.MaximumForce / RetreatTime
    : input.FadesOut               ? limits.MaximumForce / ResidentServo::FadeTime
                                   : 0.0;
  const double rate = std::max(limits.MaximumForceRate, least);
  this->Last += ClampNorm(wanted - this->Last, rate * input.Period);
  // A limit that was lowered holds at once.
  this->Last = ClampNorm(this->Last, limits.MaximumForce);
  if (!this->Stale)
  {
    const double step = limits.RampTime > 0.0 ? input.Period / limits.RampTime : 1.0;
    this->Ramp = std::min(1.0, this->Ramp + step);
  }
  return this->Last;
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
