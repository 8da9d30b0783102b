// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/ServoPriority.h"

#include "Core/Realtime/ServoClock.h"

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"
#elif defined(__APPLE__)
#include <mach/mach.h>
#include <mach/mach_time.h>
#include <mach/thread_policy.h>
#include <pthread.h>
#else
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

/** Interval (ns) at which AskRealtimeKit() polls whether Raise() was called. */
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

/** Returns the highest real-time priority that the user may set without a privilege. */
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

#if defined(_WIN32)

bool ServoPriority::RaiseThread() noexcept
{
  // The multimedia service (MMCSS) grants a class above all usual programs. It may be switched off;
  // the thread's own priority is still above that of other threads.
  using Setter = HANDLE(WINAPI*)(LPCWSTR, LPDWORD);
  static const HMODULE library = LoadLibraryExW(L"avrt.dll", nullptr, LOAD_LIBRARY_SEARCH_SYSTEM32);
  const auto set = library ? reinterpret_cast<Setter>(reinterpret_cast<void*>(
                               GetProcAddress(library, "AvSetMmThreadCharacteristicsW")))
                           : nullptr;
  DWORD task = 0;
  const bool isGranted = set && set(L"Pro Audio", &task) != nullptr;
  return SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_TIME_CRITICAL) && isGranted;
}

void ServoPriority::LowerThread() noexcept
{
  SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL);
}

#elif defined(__APPLE__)

bool ServoPriority::RaiseThread() noexcept
{
  // The class for threads with a deadline needs no privilege. The servo runs every millisecond, and
  // computes during a part of it.
  mach_timebase_info_data_t base{};
  mach_timebase_info(&base);
  const auto toTicks = [&base](std::uint64_t time)
  { return static_cast<std::uint32_t>(time * base.denom / base.numer); };
  thread_time_constraint_policy_data_t policy{};
  policy.period = toTicks(1000000);
  policy.computation = toTicks(300000);
  policy.constraint = toTicks(800000);
  policy.preemptible = TRUE;
  return thread_policy_set(pthread_mach_thread_np(pthread_self()), THREAD_TIME_CONSTRAINT_POLICY,
           reinterpret_cast<thread_policy_t>(&policy),
           THREAD_TIME_CONSTRAINT_POLICY_COUNT) == KERN_SUCCESS;
}

void ServoPriority::LowerThread() noexcept
{
  pthread_set_qos_class_self_np(QOS_CLASS_UTILITY, 0);
}

#else

bool ServoPriority::RaiseThread() noexcept
{
#if defined(__linux__)
  prctl(PR_SET_TIMERSLACK, 1UL); // ns
#endif
  // The priority is below the kernel's interrupt threads (50), so that these run first.
  constexpr int wanted = 40;
  sched_param parameters{};
  parameters.sched_priority = wanted;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0)
  {
    return true;
  }
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

void ServoPriority::LowerThread() noexcept
{
#if defined(__linux__)
  // On Linux, this affects only the calling thread; POSIX specifies the whole process.
  constexpr int nice = 10;
  (void)setpriority(PRIO_PROCESS, 0, nice);
#endif
}

#endif

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
