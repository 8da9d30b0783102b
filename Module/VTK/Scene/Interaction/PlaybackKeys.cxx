// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/PlaybackKeys.h"

#include "VTK/Filter/HapticBaker.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** The largest factor by which the keys change the speed, up and down. */
constexpr double MostSpeed = 64.0;

/** The frame before or after a time; continues at the other end. */
double FindNeighbour(const std::vector<double>& times, double time, bool isNext)
{
  if (isNext)
  {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    return after == times.end() ? times.front() : *after;
  }
  const auto before = std::lower_bound(times.begin(), times.end(), time);
  return before == times.begin() ? times.back() : *(before - 1);
}

} // namespace

bool PlaybackKeys::Press(const std::string& key)
{
  // Observers of the changes may remove the device.
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const bool isSpeed = key == "comma" || key == "period";
  const bool isPlace = key == "Left" || key == "Right";
  const bool isOurs = isSpeed || isPlace || key == "space" || key == "b";
  vtkVolumeHapticsFilter* const filter = isOurs && device ? device->GetVolumeHaptics() : nullptr;
  if (!filter || filter->GetTimeUnitsPerSecond() == 0.0)
  {
    return false;
  }
  const std::vector<double> times = HapticBaker(filter).FindFrameTimes();
  if (times.size() < 2)
  {
    return false;
  }
  if (key == "space")
  {
    device->IsPlaying() ? device->Hold() : device->Play();
  }
  else if (key == "b")
  {
    device->SetPlayback((device->GetPlayback() + 1) % (vtkHapticDevice::PING_PONG + 1));
  }
  else if (isPlace)
  {
    const bool isMoving = device->HasFrames();
    device->Hold();
    const double time = isMoving ? device->GetDataTime() : times.front();
    device->SetDataTime(FindNeighbour(times, time, key == "Right"));
  }
  else
  {
    const double speed = device->GetPlaybackSpeed() * (key == "period" ? 2.0 : 0.5);
    const double size = std::clamp(std::abs(speed), 1.0 / MostSpeed, MostSpeed);
    device->SetPlaybackSpeed(std::copysign(size, speed));
  }
  return true;
}

} // namespace VolumeHaptics
