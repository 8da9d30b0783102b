// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/Wake.h"

#include <chrono>
#include <thread>

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"
#elif defined(__linux__)
#include <cstdint>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace Wake
{

#if defined(_WIN32)

namespace
{
HANDLE ToHandle(int wake) noexcept
{
  return LongToHandle(wake); // only 32 bits of a handle are significant
}
} // namespace

int Open() noexcept
{
  const HANDLE handle = CreateEventW(nullptr, FALSE, FALSE, nullptr);
  return handle ? HandleToLong(handle) : -1;
}

void Close(int wake) noexcept
{
  CloseHandle(ToHandle(wake));
}

void Set(int wake) noexcept
{
  SetEvent(ToHandle(wake));
}

void Clear(int wake) noexcept
{
  ResetEvent(ToHandle(wake));
}

#elif defined(__linux__)

int Open() noexcept
{
  return eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
}

void Close(int wake) noexcept
{
  close(wake);
}

void Set(int wake) noexcept
{
  const std::uint64_t one = 1;
  // Writing fails only if the signal is set already.
  [[maybe_unused]] const auto size = write(wake, &one, sizeof(one));
}

void Clear(int wake) noexcept
{
  std::uint64_t count = 0;
  [[maybe_unused]] const auto size = read(wake, &count, sizeof(count));
}

#else

int Open() noexcept
{
  return -1;
}

void Close(int) noexcept {}
void Set(int) noexcept {}
void Clear(int) noexcept {}

#endif

void Wait(int wake, int time) noexcept
{
  if (wake < 0)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(time));
    return;
  }
#if defined(_WIN32)
  WaitForSingleObject(ToHandle(wake), static_cast<DWORD>(time));
#elif defined(__linux__)
  pollfd watched{ wake, POLLIN, 0 };
  if (poll(&watched, 1, time) > 0)
  {
    Clear(wake);
  }
#endif
}

} // namespace Wake
} // namespace VolumeHaptics
