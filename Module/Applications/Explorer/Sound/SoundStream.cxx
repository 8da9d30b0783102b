// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Sound/SoundStream.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr std::size_t CAPACITY = 4096;   // number of ticks
constexpr double STEP = 0.001;           // s between polls for ticks
constexpr double MOST_BACKLOG = 0.3;     // s
constexpr double LONGEST_STARVED = 0.05; // s
constexpr double GAIN_TIME = 0.01;       // s in which the sound fades in from silence
// s, period in which the least backlog is searched; longer than any burst
constexpr double WINDOW = 1.0;
constexpr double SPARE_BACKLOG = 0.02; // s
constexpr double FASTER = 1.05;
} // namespace

namespace Explore
{
SoundStream::SoundStream(double samplesPerSecond)
  : SampleRate(samplesPerSecond)
  , Newest(-std::numeric_limits<double>::infinity())
  , Ticks(CAPACITY)
  , Sound(samplesPerSecond)
{
}

void SoundStream::Push(const SoundTick& tick) noexcept
{
  if (this->Ticks.Push(tick))
  {
    this->Newest.store(tick.Time, std::memory_order_release);
  }
}

void SoundStream::Render(float* samples, std::size_t count) noexcept
{
  const auto most = static_cast<std::size_t>(std::max(1.0, STEP * this->SampleRate));
  const double wanted = this->IsMuted() ? 0.0 : 1.0;
  const double gainStep = 1.0 / (GAIN_TIME * this->SampleRate);
  while (count > 0)
  {
    const std::size_t part = std::min(count, most);
    this->Advance(static_cast<double>(part) / this->SampleRate);
    this->Sound.Render(samples, part);
    for (std::size_t i = 0; i < part; ++i)
    {
      this->Gain += std::clamp(wanted - this->Gain, -gainStep, gainStep);
      samples[i] *= static_cast<float>(this->Gain);
    }
    samples += part;
    count -= part;
  }
}

void SoundStream::Advance(double seconds) noexcept
{
  const double newest = this->Newest.load(std::memory_order_acquire);
  if (!std::isfinite(newest))
  {
    return; // no tick has arrived yet
  }
  if (!this->HasBegun || newest - this->Position > MOST_BACKLOG)
  {
    this->HasBegun = true;
    this->Position = newest;
    // Discard the skipped ticks, because all of their clicks would sound at once.
    while (this->Ticks.Pop(this->Next))
    {
      this->HasNext = true;
    }
  }
  // After a restart of the servo, its times begin again, so limit the position to the newest time.
  this->Position = std::min(this->Position + this->Pace * seconds, newest);
  this->UpdateBacklog(newest - this->Position, seconds);
  this->Starved += seconds;
  while (this->HasNext || this->Ticks.Pop(this->Next))
  {
    this->HasNext = this->Next.Time > this->Position && this->Next.Time <= newest;
    if (this->HasNext)
    {
      break;
    }
    this->Sound.Feed(this->Next);
    this->Starved = 0.0;
  }
  if (this->Starved > LONGEST_STARVED)
  {
    this->Sound.Rest(seconds);
  }
}

void SoundStream::UpdateBacklog(double backlog, double seconds) noexcept
{
  this->LeastBacklog = this->WindowTime == 0.0 ? backlog : std::min(this->LeastBacklog, backlog);
  this->WindowTime += seconds;
  if (this->WindowTime >= WINDOW)
  {
    this->Pace = this->LeastBacklog > SPARE_BACKLOG ? FASTER : 1.0;
    this->WindowTime = 0.0;
  }
}
} // namespace Explore
