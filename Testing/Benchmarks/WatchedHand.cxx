// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WatchedHand.h"

#include "Core/Realtime/ServoClock.h"

#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

constexpr std::int64_t Period = 1000000; // ns

class WatchedHand : public DeviceBackend
{
public:
  WatchedHand(const Vector3& tip, LoopWatch* watch)
    : Tip(tip)
    , Watch(watch)
  {
  }

  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "watched"; }
  DeviceLimits GetLimits() const override { return {}; }
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    this->Watch->RecordTick();
    sample.Tip = this->Tip;
    sample.Fresh = true;
    sample.Time = ServoClock::Now();
    return DeviceState::Running;
  }
  DeviceState Write(const Vector3&) noexcept override { return DeviceState::Running; }
  void Quench() noexcept override {}

private:
  const Vector3 Tip;
  LoopWatch* const Watch;
};

} // namespace

LoopCounts& LoopCounts::operator+=(const LoopCounts& other)
{
  this->Ticks += other.Ticks;
  for (int cause = 0; cause < Causes; ++cause)
  {
    this->LeftOut[cause] += other.LeftOut[cause];
  }
  this->LongestWork = std::max(this->LongestWork, other.LongestWork);
  return *this;
}

LoopCounts LoopWatch::GetCounts() const
{
  LoopCounts counts;
  counts.Ticks = this->Ticks;
  std::copy(this->LeftOut, this->LeftOut + LoopCounts::Causes, counts.LeftOut);
  counts.LongestWork = this->LongestWork;
  return counts;
}

LoopWatch::Usage LoopWatch::ReadUsage() noexcept
{
  // Read the thread's clock, which stops while the thread does not run.
  timespec work{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &work);
  Usage usage;
  usage.Work = std::int64_t{ work.tv_sec } * 1000000000 + work.tv_nsec;
#ifdef RUSAGE_THREAD
  rusage used{};
  getrusage(RUSAGE_THREAD, &used);
  usage.Waits = used.ru_nvcsw;
  usage.Reads = used.ru_majflt;
#endif
  return usage;
}

void LoopWatch::RecordTick() noexcept
{
  const std::int64_t now = ServoClock::Now();
  const Usage usage = ReadUsage();
  if (this->IsResetWanted.exchange(false))
  {
    this->Ticks = 0;
    for (std::atomic<std::uint64_t>& count : this->LeftOut)
    {
      count = 0;
    }
    this->LongestWork = 0;
    this->Planned = now;
  }
  else
  {
    // Schedule the ticks by the wall clock, as the loop does. No tick comes early.
    this->Planned = std::min(this->Planned + Period, now);
    const std::int64_t leftOut = (now - this->Planned) / Period;
    this->Planned += leftOut * Period;
    const std::int64_t work = usage.Work - this->Last.Work;
    const bool hasWaited = usage.Waits - this->Last.Waits > 1 || usage.Reads > this->Last.Reads;
    const LoopCounts::Cause cause = work > Period ? LoopCounts::Computed
      : hasWaited                                 ? LoopCounts::Waited
                                                  : LoopCounts::Machine;
    this->LeftOut[cause] += static_cast<std::uint64_t>(leftOut);
    this->LongestWork = std::max<std::int64_t>(this->LongestWork, work);
    ++this->Ticks;
  }
  this->Last = usage;
}

DeviceKind MakeWatchedKind(const Vector3& tip, LoopWatch* watch)
{
  DeviceKind kind;
  kind.Name = "watched";
  kind.List = [] {
    return std::vector<DeviceListing>{ { "watched", "A hand at rest", "available" } };
  };
  kind.Make = [tip, watch](const std::string&, const DeviceOptions&,
                std::string&) -> std::unique_ptr<DeviceBackend>
  { return std::make_unique<WatchedHand>(tip, watch); };
  return kind;
}

} // namespace benchmarks
