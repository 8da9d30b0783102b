// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/PortObserver.h"

#include "Core/Safety/UnseenMotion.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Shortest time (s) over which the velocity is averaged. In this time, an encoder step of 0.06 mm
 * counts as 15 mm/s.
 */
constexpr double ObserverVelocityTime = 4e-3;
/**
 * Time (s) without motion after which the tip counts as at rest. A shorter pause may be a motion
 * that the device has not reported yet.
 */
constexpr double RestTime = 10e-3;
/** Time (s) for which a hand may still push as strongly after the force has fallen. */
constexpr double HandTime = 0.3;
/** A force rises if it is above its mean over this time (s). */
constexpr double RiseTime = 2e-3;
/** Below this force (N), the direction is unknown, and the force moves nothing. */
constexpr double LeastForce = 0.02;

} // namespace

void PortObserver::Reset() noexcept
{
  *this = PortObserver{};
}

void PortObserver::EndContact() noexcept
{
  this->IsContact = false;
  this->Work = 0.0;
  this->Excess = 0.0;
  this->RisingExcess = 0.0;
}

void PortObserver::Add(const Vector3& tip) noexcept
{
  this->Measurements[this->Count % Kept] = { this->Time, tip };
  ++this->Count;
  this->SentSum = {};
  this->SentCount = 0.0;
}

void PortObserver::BeginAt(const Vector3& tip) noexcept
{
  this->EndContact();
  this->Count = 0;
  this->Add(tip);
}

Vector3 PortObserver::EstimateVelocity() const noexcept
{
  const Measurement& last = this->Last();
  std::size_t before = 1;
  while (before + 1 < std::min(this->Count, Kept) &&
    last.Time - this->Last(before).Time < ObserverVelocityTime * (1.0 - 1e-9))
  {
    ++before;
  }
  const Measurement& first = this->Last(before);
  return (1.0 / (last.Time - first.Time)) * (last.Tip - first.Tip);
}

void PortObserver::RecordSent(const Vector3& force) noexcept
{
  this->SentSum += force;
  this->SentCount += 1.0;
}

bool PortObserver::Observe(const Vector3& tip, double time) noexcept
{
  this->Time += time;
  const double since = this->Count > 0 ? this->Time - this->Last().Time : 0.0;
  if (this->Count == 0 || IsUnseenMotion(tip - this->Last().Tip, since))
  {
    this->BeginAt(tip);
    return false;
  }
  if (!(since > 0.0) || (IsIdentical(tip, this->Last().Tip) && since < RestTime))
  {
    return false;
  }
  const Vector3 motion = tip - this->Last().Tip;
  const Vector3 force = (1.0 / std::max(1.0, this->SentCount)) * this->SentSum;
  this->Add(tip);
  this->Account(force, motion, since);
  return this->GetRisingRunAway() > RisingBound || this->GetRunAway() > ContactBound;
}

void PortObserver::Account(const Vector3& force, const Vector3& motion, double time) noexcept
{
  const double norm = Norm(force);
  this->LargestForce = std::max(norm, this->LargestForce * std::exp(-time / HandTime));
  const bool rises = norm > 1.02 * this->EarlierForce + 0.005;
  this->EarlierForce += (1.0 - std::exp(-time / RiseTime)) * (norm - this->EarlierForce);
  const Vector3 into = norm >= LeastForce ? (-1.0 / norm) * force : Vector3{};
  // Only motion along the present force counts, because a change of the force's direction does not
  // accelerate the tip.
  const double before = std::max(0.0, Dot(this->Velocity, into));
  this->Velocity = this->EstimateVelocity();
  const double speed = std::max(0.0, Dot(this->Velocity, into));
  if (!this->IsContact || !(speed > 0.0))
  {
    this->EndContact();
    this->IsContact = norm >= LeastForce;
    return;
  }
  const double way = Dot(motion, into);
  const double gain = 0.5 * LightMass * (speed * speed - before * before);
  const double push = LightMass * HandAcceleration + this->LargestForce - norm;
  const double excess = gain - push * std::max(0.0, way);
  this->Work += norm * way;
  this->Excess += excess;
  this->RisingExcess += rises ? excess : std::min(0.0, gain);
  if (this->Work < 0.0)
  {
    this->EndContact();
  }
}

double PortObserver::GetRisingRunAway() const noexcept
{
  return std::max(0.0, std::min(this->Work, this->RisingExcess));
}

double PortObserver::GetRunAway() const noexcept
{
  return std::max(0.0, std::min(this->Work, this->Excess));
}

} // namespace VolumeHaptics
