// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/StreamedTimeSpan.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Baking/ImageTimeSteps.h"

#include <algorithm>
#include <vector>

namespace VolumeHaptics
{
namespace
{

bool AreOfOneRegion(const VolumeView& a, const VolumeView& b)
{
  return std::equal(a.First, a.First + 3, b.First) &&
    std::equal(a.Dimensions, a.Dimensions + 3, b.Dimensions);
}

bool IsEarlier(const VolumeTimeStep& a, const VolumeTimeStep& b)
{
  return a.Time < b.Time;
}

/**
 * Returns the time steps of a whole series without the last one, which is a repetition of the
 * first.
 */
std::vector<VolumeTimeStep> KeepSeries(const BakedVolume& whole)
{
  std::vector<VolumeTimeStep> timeSteps;
  for (std::size_t i = 0; i + 1 < whole.TimeSteps.size(); ++i)
  {
    timeSteps.push_back(KeepTimeStep(whole, i));
  }
  return timeSteps;
}

} // namespace

void PastTimeSpans::Record(const std::shared_ptr<const BakedVolume>& span)
{
  const auto isGone = [](const std::weak_ptr<const BakedVolume>& past) { return past.expired(); };
  this->Spans.erase(
    std::remove_if(this->Spans.begin(), this->Spans.end(), isGone), this->Spans.end());
  this->Spans.emplace_back(span);
  this->Since = ServoClock::Now();
}

bool PastTimeSpans::AreGone() const
{
  constexpr std::int64_t mostWait = 200000000; // ns
  return ServoClock::Now() - this->Since > mostWait ||
    std::all_of(this->Spans.begin(), this->Spans.end(),
      [](const std::weak_ptr<const BakedVolume>& span) { return span.expired(); });
}

VolumeTimeStep KeepTimeStep(const BakedVolume& span, std::size_t number)
{
  const FieldTimeStep& timeStep = span.TimeSteps[number];
  VolumeTimeStep kept{ timeStep.Time, timeStep.Field.GetView(), timeStep.Samples };
  // A single time step has a mesh without motion.
  kept.Mesh = span.TimeSteps.size() > 1 ? timeStep.Mesh : nullptr;
  if (timeStep.Motion)
  {
    kept.Displacements = timeStep.Motion->GetView();
    kept.DisplacementSamples = timeStep.DisplacementSamples;
  }
  return kept;
}

bool GoesOnWith(const std::vector<double>& last, const std::vector<double>& next, double time)
{
  const auto after = std::upper_bound(last.begin(), last.end(), time);
  if (after == last.begin())
  {
    return false;
  }
  const auto same = std::find(next.begin(), next.end(), *(after - 1));
  const bool isAtTimeStep = *(after - 1) == time;
  const bool isFollowed =
    after != last.end() && same != next.end() && same + 1 != next.end() && same[1] == *after;
  return same != next.end() && (isAtTimeStep || isFollowed);
}

std::shared_ptr<const BakedVolume> JoinTimeSpans(
  const BakedVolume& last, const BakedVolume& next, double time)
{
  const std::vector<VolumeTimeStep> before = KeepSeries(last);
  const std::vector<VolumeTimeStep> after = KeepSeries(next);
  const bool isThere = !before.empty() && before.front().Time <= time && time <= before.back().Time;
  if (!isThere || after.empty() || next.Mesh ||
    !AreOfOneRegion(before.front().View, after.front().View))
  {
    return nullptr;
  }
  std::vector<VolumeTimeStep> timeSteps = after;
  for (auto timeStep = before.begin(); timeStep != before.end(); ++timeStep)
  {
    const bool isNext =
      timeStep != before.begin() && (timeStep - 1)->Time < time && timeStep->Time > time;
    const bool isLast =
      timeStep->Time <= time && (timeStep + 1 == before.end() || (timeStep + 1)->Time > time);
    if ((isNext || isLast) && !std::binary_search(after.begin(), after.end(), *timeStep, IsEarlier))
    {
      timeSteps.insert(
        std::upper_bound(timeSteps.begin(), timeSteps.end(), *timeStep, IsEarlier), *timeStep);
    }
  }
  std::vector<double> times;
  for (auto timeStep = timeSteps.begin(); timeStep != timeSteps.end(); ++timeStep)
  {
    // Displacements describe the motion to the next time step, so keep them only if `after` has the
    // same next time step.
    const auto same = std::lower_bound(after.begin(), after.end(), *timeStep, IsEarlier);
    const bool isOwn = same != after.end() && same->Time == timeStep->Time;
    const bool isFollowed = isOwn && same + 1 != after.end() && timeStep + 1 != timeSteps.end() &&
      (same + 1)->Time == (timeStep + 1)->Time;
    if (!isFollowed)
    {
      timeStep->Displacements = {};
      timeStep->DisplacementSamples = nullptr;
    }
    times.push_back(timeStep->Time);
  }
  const VolumeTimeStep first = timeSteps.front();
  timeSteps.push_back(first);
  return std::make_shared<const BakedVolume>(next, timeSteps, MakeSeries(times));
}

} // namespace VolumeHaptics
