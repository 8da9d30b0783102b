// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/ServoClock.h"

#if defined(__unix__)
#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <pthread.h>
#include <time.h>
#include <unistd.h>
#else
#include <chrono>
#include <thread>
#endif

namespace VolumeHaptics
{
namespace ServoClock
{

#if defined(__unix__)

namespace
{
constexpr std::int64_t Second = 1000000000;
}

std::int64_t Now() noexcept
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * Second + now.tv_nsec;
}

void SleepUntil(std::int64_t time) noexcept
{
  timespec wake{};
  wake.tv_sec = time / Second;
  wake.tv_nsec = time % Second;
  // Sleep on after a signal that was handled on this thread, so that it does not shorten the tick.
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR)
  {
  }
}

void BlockSignals() noexcept
{
  sigset_t others;
  sigfillset(&others);
  // Crash signals must not be blocked, because a handler has to end the force before the process
  // ends.
  for (const int crash : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP })
  {
    sigdelset(&others, crash);
  }
  pthread_sigmask(SIG_BLOCK, &others, nullptr);
}

std::int64_t GetProcess() noexcept
{
  return getpid();
}

#else

std::int64_t Now() noexcept
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

void SleepUntil(std::int64_t time) noexcept
{
  std::this_thread::sleep_until(
    std::chrono::steady_clock::time_point(std::chrono::nanoseconds(time)));
}

void BlockSignals() noexcept {}

std::int64_t GetProcess() noexcept
{
  return 0; // this system does not fork
}

#endif

} // namespace ServoClock
} // namespace VolumeHaptics
