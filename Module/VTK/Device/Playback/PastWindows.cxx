// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/PastWindows.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>

namespace VolumeHaptics
{

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

} // namespace VolumeHaptics
