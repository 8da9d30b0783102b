// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/TimeSteps.h"

#include <algorithm>

namespace VolumeHaptics
{

TimeSteps::Need TimeSteps::ComputeNeed(double time, bool isBackward, Playback mode) const
{
  const std::size_t count = this->Times.size();
  const bool isLoop = mode == Playback::Loop;
  const auto above = std::upper_bound(this->Times.begin(), this->Times.end(), time);
  std::size_t first =
    above == this->Times.begin() ? 0 : static_cast<std::size_t>(above - this->Times.begin()) - 1;
  const bool isOnStep = this->Times[first] == time;
  const bool isBetween = time > this->Times.back();
  if (isOnStep && isBackward && (first > 0 || isLoop))
  {
    first = this->Before(first);
  }
  else if (first + 1 == count && !isBetween && !(isLoop && !isBackward))
  {
    first = count - 2;
  }
  const bool isLoopEnd = first + 1 == count; // the interval from the last step to the first one
  const std::size_t ahead = this->After(this->After(first));
  const std::size_t behind = this->Before(first);
  const bool hasAhead = isLoop || isLoopEnd || first + 2 < count;
  const bool hasBehind = isLoop || isLoopEnd || first > 0;
  // The next step is on the other side if time can't advance: it may turn around.
  const bool takesAhead = isBackward ? !hasBehind : hasAhead;
  return { first, takesAhead ? ahead : behind };
}

} // namespace VolumeHaptics
