// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Reads a back end every millisecond, as a servo does, and checks the timestamps of its samples.
 */
#ifndef ReadTimes_h
#define ReadTimes_h

#include "Core/Realtime/ServoClock.h"
#include "Core/Safety/DeviceBackend.h"
#include "Core/Servo/LoopTiming.h"

#include <functional>

namespace devicetest
{

struct ReadTimes
{
  explicit ReadTimes(VolumeHaptics::DeviceBackend& device)
    : Device(device)
    , Timing(device.GetLimits().LeastMotion)
  {
  }

  /// Reads the device for some seconds. Calls `each` with the elapsed time (s) in every tick.
  void Run(
    double seconds, const std::function<void(double)>& each = [](double) {})
  {
    using namespace VolumeHaptics;
    const std::int64_t begin = ServoClock::Now();
    std::int64_t now = begin;
    const auto end = begin + static_cast<std::int64_t>(1e9 * seconds);
    for (; now < end; now = ServoClock::Now())
    {
      each(1e-9 * static_cast<double>(now - begin));
      this->Tick(now);
      ServoClock::SleepUntil(now + ServoClock::Millisecond);
    }
    this->Elapsed = 1e-9 * static_cast<double>(now - begin);
  }
  /// Returns whether the device stops sending samples, or reports a loss, within some seconds.
  bool FallsSilent(double seconds, double silence)
  {
    this->SilentSince = VolumeHaptics::ServoClock::Now();
    bool fell = false;
    this->Run(
      seconds, [&](double) { fell = fell || this->LongestSilence >= silence || this->IsLost; });
    return fell;
  }

  VolumeHaptics::DeviceBackend& Device;
  VolumeHaptics::LoopTiming Timing;
  int Ticks = 0;
  int Fresh = 0;
  int Signs = 0;               ///< number of signs of life without a new position
  double Elapsed = 0.0;        ///< s since the start
  double LongestSilence = 0.0; ///< s without a sample
  double LargestSpeed = 0.0;   ///< m/s between two samples
  bool IsLost = false;
  VolumeHaptics::Vector3 Tip;

private:
  void Tick(std::int64_t now)
  {
    using namespace VolumeHaptics;
    DeviceSample sample;
    this->IsLost = this->Device.Read(1e-3, sample) == DeviceState::Lost || this->IsLost;
    ++this->Ticks;
    this->Fresh += sample.Fresh ? 1 : 0;
    this->Signs += sample.Alive && !sample.Fresh ? 1 : 0;
    this->SilentSince = sample.Fresh || sample.Alive ? now : this->SilentSince;
    this->LongestSilence =
      std::max(this->LongestSilence, 1e-9 * static_cast<double>(now - this->SilentSince));
    const double way = this->Timing.RecordSample(sample, now);
    if (way > 0.0)
    {
      this->LargestSpeed = std::max(this->LargestSpeed, Norm(sample.Tip - this->Tip) / way);
    }
    this->Tip = sample.Fresh ? sample.Tip : this->Tip;
    this->Device.Write({});
    this->Timing.RecordTaken(sample.Taken);
  }

  std::int64_t SilentSince = VolumeHaptics::ServoClock::Now();
};

} // namespace devicetest

#endif
