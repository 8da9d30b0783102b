// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/ServoPriority.h"

#include "Core/Realtime/ServoClock.h"

#if defined(__unix__)
#include <algorithm>
#include <pthread.h>
#include <sched.h>
#endif
#if defined(__linux__)
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace
{

/** Pause (ns) between two checks in AskRealtimeKit() whether Raise() was called. */
constexpr std::int64_t LookPeriod = 5000000;

#if defined(__linux__)

/** Shortest time slice (ns) that the kernel grants. */
constexpr std::uint64_t ShortestSlice = 100000;

/** The first version of the kernel's struct sched_attr, which older C libraries lack. */
struct SchedulingAttributes
{
  std::uint32_t Size = sizeof(SchedulingAttributes);
  std::uint32_t Policy = 0;
  std::uint64_t Flags = 0;
  std::int32_t Nice = 0;
  std::uint32_t Priority = 0;
  std::uint64_t Slice = 0; ///< sched_runtime in ns, which kernels before 6.12 ignore
  std::uint64_t Deadline = 0;
  std::uint64_t Period = 0;
};

void RequestShortSlices() noexcept
{
  SchedulingAttributes attributes;
  if (syscall(SYS_sched_getattr, 0, &attributes, sizeof(attributes), 0) == 0)
  {
    attributes.Size = sizeof(attributes);
    attributes.Slice = ShortestSlice;
    syscall(SYS_sched_setattr, 0, &attributes, 0);
  }
}

std::int64_t GetThread() noexcept
{
  return syscall(SYS_gettid);
}

/** Returns the highest real-time priority that the user may have without a privilege. */
int GetAllowedPriority() noexcept
{
  rlimit limit{};
  return getrlimit(RLIMIT_RTPRIO, &limit) == 0
    ? static_cast<int>(std::min<rlim_t>(limit.rlim_cur, sched_get_priority_max(SCHED_FIFO)))
    : 0;
}

#else

std::int64_t GetThread() noexcept
{
  return 0;
}

#endif

} // namespace

bool ServoPriority::RaiseThread() noexcept
{
#if defined(__linux__)
  prctl(PR_SET_TIMERSLACK, 1UL); // ns
#endif
#if defined(__unix__)
  // Priority below that of the kernel's interrupt threads (50), so that these run first.
  constexpr int wanted = 40;
  sched_param parameters{};
  parameters.sched_priority = wanted;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0)
  {
    return true;
  }
#endif
#if defined(__linux__)
  parameters.sched_priority = std::min(wanted, GetAllowedPriority());
  if (parameters.sched_priority > 0 &&
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0)
  {
    return true;
  }
  RequestShortSlices();
#endif
  return false;
}

void ServoPriority::Raise() noexcept
{
  this->Thread.store(GetThread(), std::memory_order_relaxed);
  this->Grant.store(
    RaiseThread() ? RealTimeGrant::Kernel : RealTimeGrant::Asked, std::memory_order_release);
}

void ServoPriority::AskRealtimeKit() noexcept
{
  while (this->GetGrant() == RealTimeGrant::Unknown)
  {
    if (this->StopRequested.load(std::memory_order_acquire))
    {
      return;
    }
    ServoClock::SleepUntil(ServoClock::Now() + LookPeriod);
  }
  if (this->GetGrant() != RealTimeGrant::Asked)
  {
    return;
  }
  RealTimeGrant grant = RealTimeGrant::NoService;
  switch (RealtimeKit::MakeRealTime(
    this->Thread.load(std::memory_order_relaxed), this->Environment, this->StopRequested))
  {
    case RealtimeKit::Answer::Granted:
      grant = RealTimeGrant::RealtimeKit;
      break;
    case RealtimeKit::Answer::Refused:
      grant = RealTimeGrant::Refused;
      break;
    case RealtimeKit::Answer::Absent:
      break;
  }
  this->Grant.store(grant, std::memory_order_release);
}

} // namespace VolumeHaptics
