// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/StreamedWindow.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Baking/HapticFrames.h"

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

bool IsEarlier(const VolumeFrame& a, const VolumeFrame& b)
{
  return a.Time < b.Time;
}

/** Returns the frames of a whole series, without the first frame that is repeated at its end. */
std::vector<VolumeFrame> KeepSeries(const BakedVolume& whole)
{
  std::vector<VolumeFrame> frames;
  for (std::size_t i = 0; i + 1 < whole.Frames.size(); ++i)
  {
    frames.push_back(KeepFrame(whole, i));
  }
  return frames;
}

} // namespace

void PastWindows::Note(const std::shared_ptr<const BakedVolume>& window)
{
  const auto isGone = [](const std::weak_ptr<const BakedVolume>& past) { return past.expired(); };
  this->Windows.erase(
    std::remove_if(this->Windows.begin(), this->Windows.end(), isGone), this->Windows.end());
  this->Windows.emplace_back(window);
  this->Since = ServoClock::Now();
}

bool PastWindows::AreGone() const
{
  constexpr std::int64_t mostWait = 200000000; // ns
  return ServoClock::Now() - this->Since > mostWait ||
    std::all_of(this->Windows.begin(), this->Windows.end(),
      [](const std::weak_ptr<const BakedVolume>& window) { return window.expired(); });
}

VolumeFrame KeepFrame(const BakedVolume& window, std::size_t number)
{
  const FieldFrame& frame = window.Frames[number];
  VolumeFrame kept{ frame.Time, frame.Field.GetView(), frame.Samples };
  // The mesh of a single frame does not move.
  kept.Mesh = window.Frames.size() > 1 ? frame.Mesh : nullptr;
  if (frame.Motion)
  {
    kept.Displacements = frame.Motion->GetView();
    kept.DisplacementSamples = frame.DisplacementSamples;
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
  const bool isAtFrame = *(after - 1) == time;
  const bool isFollowed =
    after != last.end() && same != next.end() && same + 1 != next.end() && same[1] == *after;
  return same != next.end() && (isAtFrame || isFollowed);
}

std::shared_ptr<const BakedVolume> JoinWindows(
  const BakedVolume& last, const BakedVolume& next, double time)
{
  const std::vector<VolumeFrame> before = KeepSeries(last);
  const std::vector<VolumeFrame> after = KeepSeries(next);
  const bool isThere = !before.empty() && before.front().Time <= time && time <= before.back().Time;
  if (!isThere || after.empty() || next.Mesh ||
    !AreOfOneRegion(before.front().View, after.front().View))
  {
    return nullptr;
  }
  std::vector<VolumeFrame> frames = after;
  for (auto frame = before.begin(); frame != before.end(); ++frame)
  {
    const bool isNext = frame != before.begin() && (frame - 1)->Time < time && frame->Time > time;
    const bool isLast =
      frame->Time <= time && (frame + 1 == before.end() || (frame + 1)->Time > time);
    if ((isNext || isLast) && !std::binary_search(after.begin(), after.end(), *frame, IsEarlier))
    {
      frames.insert(std::upper_bound(frames.begin(), frames.end(), *frame, IsEarlier), *frame);
    }
  }
  std::vector<double> times;
  for (auto frame = frames.begin(); frame != frames.end(); ++frame)
  {
    // Displacements lead to the next frame, so they are kept only if the next frame is the same.
    const auto same = std::lower_bound(after.begin(), after.end(), *frame, IsEarlier);
    const bool isOwn = same != after.end() && same->Time == frame->Time;
    const bool isFollowed = isOwn && same + 1 != after.end() && frame + 1 != frames.end() &&
      (same + 1)->Time == (frame + 1)->Time;
    if (!isFollowed)
    {
      frame->Displacements = {};
      frame->DisplacementSamples = nullptr;
    }
    times.push_back(frame->Time);
  }
  const VolumeFrame first = frames.front();
  frames.push_back(first);
  return std::make_shared<const BakedVolume>(next, frames, MakeSeries(times));
}

} // namespace VolumeHaptics
