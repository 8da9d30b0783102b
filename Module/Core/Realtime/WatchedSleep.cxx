// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/WatchedSleep.h"

#include "Core/Realtime/ServoClock.h"
#include "Core/Realtime/ServoPriority.h"

#if defined(__linux__)
#include <algorithm>
#include <cerrno>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{

#if defined(__linux__)

namespace
{

/** The watcher tolerates a delay of the sleeper up to this time (ns). */
constexpr std::int64_t MostPatience = 300000;
/**
 * Shortest and longest pause (ns) of the watcher between two checks. The pause saves processor
 * time, and is short enough to react soon to a request to stop.
 */
constexpr std::int64_t LeastPause = 250000;
constexpr std::int64_t MostPause = 5000000;

#if defined(SYS_futex_time64)
constexpr long FutexCall = sizeof(time_t) > sizeof(long) ? SYS_futex_time64 : SYS_futex;
#else
constexpr long FutexCall = SYS_futex;
#endif

/**
 * Reads which processors a thread may use. `thread` is 0 for the calling thread. Returns false if
 * the kernel does not report them.
 */
bool GetProcessors(std::int64_t thread, cpu_set_t& processors) noexcept
{
  return sched_getaffinity(static_cast<pid_t>(thread), sizeof(processors), &processors) == 0;
}

bool SetProcessors(std::int64_t thread, const cpu_set_t& processors) noexcept
{
  return sched_setaffinity(static_cast<pid_t>(thread), sizeof(processors), &processors) == 0;
}

bool Contains(const cpu_set_t& processors, int processor) noexcept
{
  return processor >= 0 && processor < CPU_SETSIZE && CPU_ISSET(processor, &processors);
}

} // namespace

WatchedSleep::WatchedSleep(std::int64_t period) noexcept
  : Patience(std::min(MostPatience, period / 2))
{
}

void WatchedSleep::SleepUntil(std::int64_t planned, std::int64_t alarm) noexcept
{
  constexpr std::int64_t second = 1000000000;
  timespec end{};
  end.tv_sec = static_cast<time_t>(alarm / second);
  end.tv_nsec = static_cast<long>(alarm % second);
  if (this->Sleeper.load(std::memory_order_relaxed) == 0)
  {
    this->Sleeper.store(syscall(SYS_gettid), std::memory_order_relaxed);
  }
  this->Processor.store(sched_getcpu(), std::memory_order_relaxed);
  std::uint32_t wakes = this->Wakes.load(std::memory_order_acquire);
  this->Planned.store(planned, std::memory_order_release);
  // Continue to sleep if a signal, or a late watcher, has woken the thread too early.
  while (ServoClock::Now() < planned)
  {
    if (syscall(FutexCall, &this->Wakes, FUTEX_WAIT_BITSET_PRIVATE, wakes, &end, nullptr,
          FUTEX_BITSET_MATCH_ANY) != 0 &&
      errno != EAGAIN && errno != EINTR && errno != ETIMEDOUT)
    {
      ServoClock::SleepUntil(alarm);
    }
    wakes = this->Wakes.load(std::memory_order_acquire);
  }
  this->Planned.store(0, std::memory_order_release);
  Binding bound = Binding::Bound;
  if (this->State.load(std::memory_order_relaxed) == bound &&
    this->State.compare_exchange_strong(bound, Binding::Ending, std::memory_order_acquire))
  {
    this->GiveBack(); // if this fails, the watcher restores the set of allowed processors
    this->State.store(Binding::None, std::memory_order_release);
  }
}

void WatchedSleep::Watch() noexcept
{
  ServoPriority::RaiseThread();
  cpu_set_t own;
  if (!GetProcessors(0, own))
  {
    return; // there are too many processors
  }
  std::int64_t counted = 0;
  while (!this->StopRequested.load(std::memory_order_acquire))
  {
    this->EndBinding();
    const bool isApart = this->StandApart();
    const std::int64_t planned = this->Planned.load(std::memory_order_acquire);
    if (isApart && planned != 0 && ServoClock::Now() >= planned + this->Patience &&
      this->WakeHere(planned) && planned != counted)
    {
      this->Rescues.fetch_add(1);
      counted = planned;
    }
    const std::int64_t now = ServoClock::Now();
    const std::int64_t next = this->Planned.load(std::memory_order_relaxed) + this->Patience;
    ServoClock::SleepUntil(
      isApart ? std::clamp(next, now + LeastPause, now + MostPause) : now + MostPause);
  }
  this->EndBinding();
}

/**
 * Moves the watcher away from the sleeper, to another processor that the sleeper may use. Returns
 * false if there is none.
 */
bool WatchedSleep::StandApart() noexcept
{
  cpu_set_t allowed;
  const std::int64_t sleeper = this->Sleeper.load(std::memory_order_relaxed);
  if (sleeper == 0 || !GetProcessors(sleeper, allowed))
  {
    return false;
  }
  const int processor = this->Processor.load(std::memory_order_relaxed);
  if (this->Left == processor && Contains(allowed, sched_getcpu()))
  {
    return true;
  }
  if (Contains(allowed, processor))
  {
    CPU_CLR(processor, &allowed);
  }
  const bool isApart = CPU_COUNT(&allowed) > 0 && SetProcessors(0, allowed);
  this->Left = isApart ? processor : -1;
  return isApart;
}

/**
 * Wakes the sleeper on the watcher's processor if the sleeper may run there. Returns whether the
 * sleeper was bound to this processor.
 */
bool WatchedSleep::WakeHere(std::int64_t planned) noexcept
{
  const std::int64_t sleeper = this->Sleeper.load(std::memory_order_relaxed);
  const int here = sched_getcpu();
  if (this->IsOwing || this->State.load(std::memory_order_acquire) != Binding::None ||
    !GetProcessors(sleeper, this->Allowed) || !Contains(this->Allowed, here))
  {
    return false;
  }
  CPU_ZERO(&this->Here);
  CPU_SET(here, &this->Here);
  if (this->Planned.load(std::memory_order_acquire) != planned)
  {
    return false; // the sleeper has woken up by itself
  }
  this->State.store(Binding::Bound, std::memory_order_release);
  const bool isBound = SetProcessors(sleeper, this->Here);
  if (isBound)
  {
    this->Wakes.fetch_add(1, std::memory_order_release);
    syscall(FutexCall, &this->Wakes, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
  }
  // The binding must be ended even if State is None again, because the sleeper may have checked
  // State before it was bound.
  this->IsOwing = true;
  this->EndBinding();
  return isBound;
}

/**
 * Ends the binding if the sleeper has not done so. The watcher repeats this call until it succeeds.
 */
void WatchedSleep::EndBinding() noexcept
{
  if (this->IsOwing && this->GiveBack())
  {
    this->IsOwing = false;
    Binding bound = Binding::Bound;
    this->State.compare_exchange_strong(bound, Binding::None, std::memory_order_acq_rel);
  }
}

/**
 * Allows the sleeper to use its original processors again. Both threads may call this at the same
 * time, with the same effect. Returns whether the sleeper is no longer bound.
 */
bool WatchedSleep::GiveBack() const noexcept
{
  const std::int64_t sleeper = this->Sleeper.load(std::memory_order_relaxed);
  cpu_set_t now;
  if (!GetProcessors(sleeper, now))
  {
    return errno == ESRCH; // true if the sleeper's thread has ended
  }
  return !CPU_EQUAL(&now, &this->Here) || SetProcessors(sleeper, this->Allowed);
}

#else

WatchedSleep::WatchedSleep(std::int64_t) noexcept {}

void WatchedSleep::SleepUntil(std::int64_t, std::int64_t alarm) noexcept
{
  ServoClock::SleepUntil(alarm);
}

void WatchedSleep::Watch() noexcept {}

#endif

} // namespace VolumeHaptics
