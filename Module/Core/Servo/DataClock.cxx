// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/DataClock.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * A tick crosses at most this many ends of series and intervals. The rest of its time is dropped.
 */
constexpr int MostTurns = 8;

} // namespace

void DataClock::Rest() noexcept
{
  const std::uint32_t places = this->Report.Places;
  this->Report = {};
  this->Report.Places = places;
  this->Number = 0;
}

DataClock::Leap DataClock::Update(const BakedVolume& volume, const DataClockOrders& orders,
  double period, ServoState& state) noexcept
{
  const TimeSpan span = volume.GetTimeSpan();
  const bool isNew = this->Number != volume.Number;
  this->Number = volume.Number;
  double time = state.DataTime;
  Leap leap = Leap::None;
  if (!this->HasTime || !span.Has(time))
  {
    // It is another volume, or its time steps have other times.
    const double first = span.Series.First;
    time = !this->HasTime && span.Has(first) ? first : span.Front;
    leap = Leap::Away;
  }
  this->HasTime = true;
  this->Report = {};
  this->Report.IsMoving = true;
  this->Report.Places = orders.Places;
  if (orders.Places != this->Places)
  {
    const Leap there = this->AdvanceToPlace(span, orders, time);
    leap = leap == Leap::Away ? leap : there;
  }
  this->WasInstant = span.IsInstant;
  this->IsReturning = this->IsReturning && orders.Mode == Playback::PingPong;
  if (orders.Plays && !this->Report.IsWaiting)
  {
    this->Advance(span, orders, std::abs(orders.Rate) * period, time);
  }
  this->Report.IsBackward = this->IsBackward(orders);
  state.DataTime = time;
  if (isNew)
  {
    // The proxy can't be carried from one volume to another.
    state.CarriedTo = time;
  }
  return leap;
}

DataClock::Leap DataClock::AdvanceToPlace(
  const TimeSpan& span, const DataClockOrders& orders, double& time) noexcept
{
  const double place = std::clamp(orders.Place, span.Series.First, span.Series.Last);
  if (!span.Has(place))
  {
    this->Report.IsWaiting = true;
    this->Report.Wanted = place;
    return Leap::None;
  }
  this->Places = orders.Places;
  const bool isElsewhere = time != place;
  time = place;
  const Leap leap = this->WasInstant ? Leap::Away : Leap::Within;
  return isElsewhere ? leap : Leap::None;
}

void DataClock::Advance(
  const TimeSpan& span, const DataClockOrders& orders, double way, double& time) noexcept
{
  const TimeStepSeries& series = span.Series;
  for (int i = 0; i < MostTurns && way > 0.0; ++i)
  {
    const bool isBackward = this->IsBackward(orders);
    const double end = isBackward ? series.First : series.Last;
    if (time == end && orders.Mode == Playback::PingPong)
    {
      this->IsReturning = !this->IsReturning;
      continue;
    }
    if (time == end && orders.Mode == Playback::Once)
    {
      return;
    }
    const double from = time == end && isBackward ? series.First + series.GetPeriod() : time;
    const bool isBetween = from > series.Last || (from == series.Last && !isBackward);
    const double turn = isBackward ? series.Last : series.First + series.GetPeriod();
    const double toStop = std::abs((isBetween ? turn : end) - from);
    const double there = isBackward ? span.GetBehind(time) : span.GetAhead(time);
    const double step = std::min({ way, toStop, there });
    way -= step;
    if (step < toStop)
    {
      time = isBackward ? from - step : from + step;
    }
    else
    {
      // Continue at the other end of the series, after the interval from the last time step to the
      // first.
      time = isBetween ? (isBackward ? series.Last : series.First) : end;
    }
    if (step == there || !span.Has(time))
    {
      time = isBackward ? span.Front : span.Back;
    }
    if (there < toStop && way > 0.0)
    {
      this->Report.IsWaiting = true;
      this->Report.Wanted = time;
      return;
    }
  }
}

} // namespace VolumeHaptics
