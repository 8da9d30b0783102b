// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/ServoClock.h"

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>
#else
#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <pthread.h>
#include <time.h>
#include <unistd.h>
#endif
#if defined(__APPLE__)
#include <mach/mach_time.h>
#endif

namespace VolumeHaptics
{
namespace ServoClock
{

#if defined(_WIN32)

namespace
{

/**
 * A high-resolution timer for each thread, accurate to half a millisecond. The usual timers may be
 * 16 ms late.
 */
class Timer
{
public:
  bool SleepUntil(std::int64_t time) noexcept
  {
    const std::int64_t left = time - Now();
    if (left <= 0)
    {
      return true;
    }
    LARGE_INTEGER wait{};
    wait.QuadPart = -std::max<std::int64_t>(1, left / 100); // < 0: relative; in units of 100 ns
    return this->Handle.Get() &&
      SetWaitableTimer(this->Handle.Get(), &wait, 0, nullptr, nullptr, FALSE) &&
      WaitForSingleObject(this->Handle.Get(), INFINITE) == WAIT_OBJECT_0;
  }

private:
#if !defined(CREATE_WAITABLE_TIMER_HIGH_RESOLUTION)
  static constexpr DWORD CREATE_WAITABLE_TIMER_HIGH_RESOLUTION = 2; // since Windows 10, 1803
#endif
  static HANDLE Make() noexcept
  {
    const HANDLE precise = CreateWaitableTimerExW(
      nullptr, nullptr, CREATE_WAITABLE_TIMER_HIGH_RESOLUTION, TIMER_ALL_ACCESS);
    return precise ? precise : CreateWaitableTimerExW(nullptr, nullptr, 0, TIMER_ALL_ACCESS);
  }
  const WindowsHandle Handle{ Make() };
};

} // namespace

std::int64_t Now() noexcept
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

void SleepUntil(std::int64_t time) noexcept
{
  static thread_local Timer timer;
  while (Now() < time)
  {
    if (!timer.SleepUntil(time))
    {
      std::this_thread::sleep_until(
        std::chrono::steady_clock::time_point(std::chrono::nanoseconds(time)));
    }
  }
}

std::int64_t GetTimeAsleep() noexcept
{
  using Reader = void(WINAPI*)(PULONGLONG);
  static const auto readers = []
  {
    const HMODULE library =
      GetModuleHandleW(L"kernelbase.dll"); // its import library may be missing
    const auto find = [library](const char* name)
    { return library ? reinterpret_cast<void*>(GetProcAddress(library, name)) : nullptr; };
    return std::make_pair(reinterpret_cast<Reader>(find("QueryInterruptTimePrecise")),
      reinterpret_cast<Reader>(find("QueryUnbiasedInterruptTimePrecise")));
  }();
  ULONGLONG whole = 0; // in units of 100 ns
  ULONGLONG awake = 0;
  if (readers.first && readers.second)
  {
    readers.first(&whole);
    readers.second(&awake);
  }
  return static_cast<std::int64_t>(whole - awake) * 100;
}

void BlockSignals() noexcept {} // no effect: Windows handles signals in another thread

std::int64_t GetProcess() noexcept
{
  return GetCurrentProcessId();
}

#else

#if defined(__APPLE__)

namespace
{
const mach_timebase_info_data_t& GetTimebase() noexcept
{
  static const mach_timebase_info_data_t base = []
  {
    mach_timebase_info_data_t read{};
    mach_timebase_info(&read);
    return read;
  }();
  return base;
}
} // namespace

std::int64_t Now() noexcept
{
  // Use integers. Unlike doubles, they lose no digits, and this formula does not overflow for
  // years.
  const mach_timebase_info_data_t& base = GetTimebase();
  const std::uint64_t ticks = mach_absolute_time();
  return static_cast<std::int64_t>(
    ticks / base.denom * base.numer + ticks % base.denom * base.numer / base.denom);
}

void SleepUntil(std::int64_t time) noexcept
{
  const mach_timebase_info_data_t& base = GetTimebase();
  const auto until = static_cast<std::uint64_t>(time > 0 ? time : 0);
  const std::uint64_t ticks =
    until / base.numer * base.denom + until % base.numer * base.denom / base.numer + 1;
  while (Now() < time)
  {
    mach_wait_until(ticks);
  }
}

std::int64_t GetTimeAsleep() noexcept
{
  const mach_timebase_info_data_t& base = GetTimebase();
  const std::uint64_t ticks = mach_continuous_time() - mach_absolute_time();
  return static_cast<std::int64_t>(ticks * base.numer / base.denom);
}

#else

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
  // If a signal was handled on this thread, continue to sleep, so that the tick does not get
  // shorter.
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR)
  {
  }
}

std::int64_t GetTimeAsleep() noexcept
{
#if defined(__linux__)
  timespec whole{};
  timespec awake{};
  clock_gettime(CLOCK_BOOTTIME, &whole);
  clock_gettime(CLOCK_MONOTONIC, &awake);
  return (whole.tv_sec - awake.tv_sec) * Second + whole.tv_nsec - awake.tv_nsec;
#else
  return 0;
#endif
}

#endif

void BlockSignals() noexcept
{
  sigset_t others;
  sigfillset(&others);
  // Crash signals must not be blocked, because their handler has to end the force before the
  // process ends.
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

#endif

} // namespace ServoClock
} // namespace VolumeHaptics
