// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/Pages.h"

#include <algorithm>

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"

#include <malloc.h>
#else
#include <cerrno>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{
namespace Pages
{

#if defined(_WIN32)

std::size_t GetSize() noexcept
{
  static const std::size_t size = []
  {
    SYSTEM_INFO info{};
    GetSystemInfo(&info);
    return std::size_t{ info.dwPageSize };
  }();
  return size;
}

bool Lock(void* address, std::size_t size) noexcept
{
  if (VirtualLock(address, size))
  {
    return true;
  }
  // Windows lets a process lock only about as much as its minimum working set, initially some 200
  // KiB. Raise the minimum and try again.
  SIZE_T least = 0;
  SIZE_T most = 0;
  constexpr std::size_t spare = std::size_t{ 1 } << 20;
  return GetLastError() == ERROR_WORKING_SET_QUOTA &&
    GetProcessWorkingSetSize(GetCurrentProcess(), &least, &most) &&
    SetProcessWorkingSetSize(GetCurrentProcess(), least + size + spare,
      std::max(most, least + size + spare) + size + spare) &&
    VirtualLock(address, size);
}

bool Unlock(void* address, std::size_t size) noexcept
{
  return VirtualUnlock(address, size) != FALSE;
}

void LockAll() noexcept {} // no such call

void Request(void* address, std::size_t size) noexcept
{
  WIN32_MEMORY_RANGE_ENTRY range{ address, size };
  PrefetchVirtualMemory(GetCurrentProcess(), 1, &range, 0);
}

bool Fetch(void*, std::size_t) noexcept
{
  return false;
}

void MakeLarge(void*, std::size_t) noexcept {} // needs a privilege

Stack FindFreeStack(std::size_t size) noexcept
{
  ULONG_PTR lowest = 0;
  ULONG_PTR highest = 0;
  GetCurrentThreadStackLimits(&lowest, &highest);
  // The system commits the stack page by page, when the guard page is touched.
  const char here = 0;
  const auto left = static_cast<std::size_t>(reinterpret_cast<ULONG_PTR>(&here) - lowest);
  const std::size_t kept = 4 * GetSize(); // the guard page, and room for the calls
  const std::size_t used = left > kept ? std::min(size, left - kept) : 0;
  auto* const made = static_cast<volatile char*>(_alloca(used + 1));
  for (std::size_t at = used; at > 0; at -= std::min(at, GetSize()))
  {
    made[at] = 0;
  }
  return { const_cast<const char*>(made), used };
}

#else

std::size_t GetSize() noexcept
{
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
}

bool Lock(void* address, std::size_t size) noexcept
{
  return mlock(address, size) == 0;
}

bool Unlock(void* address, std::size_t size) noexcept
{
  return munlock(address, size) == 0;
}

void LockAll() noexcept
{
  (void)mlockall(MCL_CURRENT);
}

void Request(void* address, std::size_t size) noexcept
{
  madvise(address, size, MADV_WILLNEED);
}

bool Fetch([[maybe_unused]] void* address, [[maybe_unused]] std::size_t size) noexcept
{
#if defined(__linux__)
  constexpr int populateForReading = 22; // MADV_POPULATE_READ of Linux 5.14
  // EINVAL means that this kernel does not have the call. After any other error, reading the pages
  // would crash the process.
  return madvise(address, size, populateForReading) == 0 || errno != EINVAL;
#else
  return false;
#endif
}

void MakeLarge([[maybe_unused]] void* address, [[maybe_unused]] std::size_t size) noexcept
{
#if defined(__linux__)
  (void)madvise(address, size, MADV_HUGEPAGE);
#endif
}

Stack FindFreeStack([[maybe_unused]] std::size_t size) noexcept
{
#if defined(__linux__)
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0)
  {
    return {};
  }
  void* lowest = nullptr;
  std::size_t whole = 0;
  pthread_attr_getstack(&attributes, &lowest, &whole);
  pthread_attr_destroy(&attributes);
#elif defined(__APPLE__)
  const void* const lowest = static_cast<char*>(pthread_get_stackaddr_np(pthread_self())) -
    pthread_get_stacksize_np(pthread_self());
#else
  return {};
#endif
#if defined(__linux__) || defined(__APPLE__)
  // On all processors for which this code is compiled, the stack grows downwards.
  const char* const here = static_cast<const char*>(__builtin_frame_address(0));
  const auto left = static_cast<std::size_t>(here - static_cast<const char*>(lowest));
  const std::size_t used = std::min(size, left);
  return { here - used, used };
#endif
}

#endif

} // namespace Pages
} // namespace VolumeHaptics
