// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/EnergyObserver.h"

#include "Core/Safety/UnseenMotion.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** E has changed direction when it has returned by this fraction of the last swing. */
constexpr double Turn = 0.2;
/**
 * E must also return by at least the force times this length (m), because the steps of an encoder,
 * which differ between axes, change E, too.
 */
constexpr double StepWay = 1e-4;
/** A single cycle counts with at most this ratio given / taken. */
constexpr double MostGain = 2.0;

} // namespace

void EnergyObserver::Reset() noexcept
{
  *this = EnergyObserver{};
}

void EnergyObserver::Excuse() noexcept
{
  this->Count = 0;
  this->Largest = 0.0;
  this->HasPeak = false;
}

void EnergyObserver::RecordSent(const Vector3& force, double wallWork) noexcept
{
  this->Energy -= wallWork;
  this->WallWork += std::abs(wallWork);
  this->SentSum += force;
  this->SentCount += 1.0;
}

bool EnergyObserver::Observe(const Vector3& tip, double time) noexcept
{
  const Vector3 force = (1.0 / std::max(1.0, this->SentCount)) * this->SentSum;
  const Vector3 motion = tip - this->Tip;
  this->SentSum = {};
  this->SentCount = 0.0;
  this->Time += time;
  this->Tip = tip;
  if (!this->HasTip || IsUnseenMotion(motion, time))
  {
    this->HasTip = true;
    this->Excuse();
    return false;
  }
  this->Path += Norm(motion);
  this->Energy += Dot(force, motion);
  this->Force = Norm(force);
  return this->UpdateEnergy();
}

bool EnergyObserver::UpdateEnergy() noexcept
{
  const double ahead = (this->Rises ? 1.0 : -1.0) * (this->Energy - this->Extreme.Energy);
  if (ahead >= 0.0)
  {
    this->Extreme = this->Now();
    return false;
  }
  if (-ahead < std::max({ LeastSwing, Turn * this->Swing, StepWay * this->Force }))
  {
    // After a rest, forget the last swing, so that a much smaller swing is detected, too.
    const bool rests = this->Time - this->Extreme.Time > LongestCycle;
    this->Swing = rests ? 0.0 : this->Swing;
    return false;
  }
  const Instant turned = this->Extreme;
  this->Extreme = this->Now();
  this->Rises = !this->Rises;
  if (this->Rises)
  {
    this->Low = turned.Energy;
    return false;
  }
  const Instant from = this->Peak;
  this->Swing = turned.Energy - this->Low;
  this->Peak = turned;
  if (!this->HasPeak)
  {
    this->HasPeak = true;
    return false;
  }
  return this->CountCycle(from, turned, this->Low);
}

bool EnergyObserver::CountCycle(const Instant& from, const Instant& to, double low) noexcept
{
  const double path = to.Path - from.Path;
  const bool isQuick = to.Time - from.Time <= LongestCycle;
  const Cycle cycle = { from.Energy - low, to.Energy - low };
  const bool isDriven = to.WallWork - from.WallWork > MostDriven * cycle.Given;
  const bool isSwing = path >= LeastPath && Norm(to.Tip - from.Tip) <= 0.5 * path && !isDriven;
  if (!isQuick || !isSwing || cycle.Given < LeastShare * this->Largest)
  {
    this->Count = 0;
    this->Largest = 0.0;
  }
  if (!isQuick || !isSwing)
  {
    return false;
  }
  this->Row[this->Count % Cycles] = cycle;
  ++this->Count;
  this->Largest = std::max(this->Largest, cycle.Given);
  const bool gives = this->IsGiving(Cycles, 0.0) || this->IsGiving(FewCycles, MuchGiven);
  if (gives)
  {
    this->Excuse();
    this->HasPeak = true;
  }
  return gives;
}

/** Returns whether the last `cycles` cycles of the row give energy. */
bool EnergyObserver::IsGiving(std::size_t cycles, double leastGain) const noexcept
{
  if (this->Count < cycles)
  {
    return false;
  }
  double taken = 0.0;
  double halves[2] = { 0.0, 0.0 };
  double gain = 1.0;
  for (std::size_t i = 0; i < cycles; ++i)
  {
    const Cycle& cycle = this->Row[(this->Count - cycles + i) % Cycles];
    taken += cycle.Taken;
    halves[2 * i / cycles] += cycle.Given;
    gain *= std::min(MostGain, cycle.Given / std::max(cycle.Taken, LeastSwing));
  }
  const double given = halves[0] + halves[1];
  return given >= LeastEnergy && given >= LeastReturn * taken &&
    halves[1] >= LeastLasting * halves[0] && gain >= leastGain;
}

} // namespace VolumeHaptics
