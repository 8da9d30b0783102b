// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/LoopTiming.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Longest time (ns) that counts as a round trip. A longer one is a gap, which the watchdog handles.
 */
constexpr std::int64_t LongestRoundTrip = 100000000;
/**
 * Least number of encoder steps between two reports of a moving tip. With fewer steps, the tip may
 * have rested most of the time.
 */
constexpr double StepsOfMotion = 3.0;

double ToSeconds(std::int64_t nanoseconds)
{
  return static_cast<double>(nanoseconds) * ServoClock::SecondsPerNanosecond;
}

} // namespace

const LoopTiming::Measurement* LoopTiming::Find(std::int64_t time) const noexcept
{
  for (std::size_t back = 1; back <= Kept && back <= this->Count; ++back)
  {
    const Measurement& m = this->Last[(this->Count - back) % Kept];
    if (m.Time == time)
    {
      return &m;
    }
  }
  return nullptr;
}

double LoopTiming::RecordSample(const DeviceSample& sample, std::int64_t now) noexcept
{
  if (sample.Begins)
  {
    this->Continues = false;
  }
  if (!sample.Fresh)
  {
    this->AliveAt = sample.Alive ? now : this->AliveAt;
    return 0.0;
  }
  Measurement next{ sample.Time, sample.Time, false };
  std::int64_t motion = 0;
  if (this->Continues)
  {
    Measurement& before = this->Last[(this->Count - 1) % Kept];
    const std::int64_t interval = sample.Time - before.Time;
    if (interval <= 0)
    {
      return 0.0; // the clock has not advanced
    }
    next.TellsPeriod = interval <= LongestPeriod &&
      (this->LeastMotion == 0.0 || Norm(sample.Tip - this->Tip) >= StepsOfMotion * LeastMotion);
    if (next.TellsPeriod)
    {
      this->Reports.Add(interval);
    }
    // The last "no motion" report may be up to one report period old, so the motion may have begun
    // that much earlier.
    const std::int64_t known = this->AliveAt - this->Reports.GetUpper();
    if (this->Reports.GetUpper() > 0 && this->AliveAt > before.Time)
    {
      before.Until = std::clamp(known, before.Time, sample.Time);
    }
    motion = std::max(sample.Time - before.Until, this->Reports.GetTypical());
  }
  this->Last[this->Count % Kept] = next;
  ++this->Count;
  this->Tip = sample.Tip;
  this->Continues = true;
  return ToSeconds(motion);
}

void LoopTiming::RecordTaken(const TakenForce& taken) noexcept
{
  if (taken.Of <= this->Acting.Of)
  {
    return;
  }
  const Measurement* const before = this->Find(this->Acting.Of);
  const Measurement* const next = this->Find(taken.Of);
  if (before && next && next->TellsPeriod)
  {
    const std::int64_t late = std::max<std::int64_t>(0, this->Acting.At - before->Until);
    const std::int64_t whole = late + taken.At - before->Until;
    if (whole > 0 && whole <= LongestRoundTrip)
    {
      this->RoundTrips.Add(whole);
    }
  }
  this->Acting = taken;
}

double LoopTiming::GetReportPeriod() const noexcept
{
  return ToSeconds(this->Reports.GetUpper());
}

double LoopTiming::GetRoundTrip() const noexcept
{
  return ToSeconds(this->RoundTrips.GetUpper());
}

} // namespace VolumeHaptics
