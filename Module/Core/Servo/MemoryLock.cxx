// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/MemoryLock.h"

#include "Core/Servo/PerProcess.h"

#if defined(__unix__)
#include <algorithm>
#include <cerrno>
#include <mutex>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>
#include <unordered_map>
#endif

namespace VolumeHaptics
{

#if defined(__unix__)

std::size_t GetPageSize() noexcept
{
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
}

namespace
{

#if defined(__linux__)
/** MADV_POPULATE_READ of Linux 5.14, which older headers lack. */
constexpr int PopulateForReading = 22;
#endif

/** Counts the locks on each page of a process. */
class PageCounts
{
public:
  static std::uintptr_t PageOf(const void* address) noexcept
  {
    return reinterpret_cast<std::uintptr_t>(address) / GetPageSize();
  }

  bool Add(std::uintptr_t first, std::uintptr_t last) noexcept
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::uintptr_t end = first; // end of the counted pages
    try
    {
      for (; end <= last; ++end)
      {
        ++this->Counts[end];
      }
      if (mlock(AddressOf(first), (last - first + 1) * GetPageSize()) == 0)
      {
        return true;
      }
    }
    catch (...) // no memory for the counts
    {
    }
    if (first < end)
    {
      this->Release(first, end - 1); // mlock may have locked some of them
    }
    return false;
  }

  void Remove(std::uintptr_t first, std::uintptr_t last) noexcept
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Release(first, last);
  }

  static void* AddressOf(std::uintptr_t page) noexcept
  {
    return reinterpret_cast<void*>(page * GetPageSize());
  }

private:
  void Release(std::uintptr_t first, std::uintptr_t last) noexcept
  {
    std::uintptr_t begin = first; // begin of a row of pages without locks
    for (std::uintptr_t page = first; page <= last; ++page)
    {
      const auto found = this->Counts.find(page);
      if (found != this->Counts.end() && --found->second > 0)
      {
        Unlock(begin, page);
        begin = page + 1;
      }
      else if (found != this->Counts.end())
      {
        this->Counts.erase(found);
      }
    }
    Unlock(begin, last + 1);
  }
  static void Unlock(std::uintptr_t begin, std::uintptr_t end) noexcept
  {
    if (begin < end)
    {
      munlock(AddressOf(begin), (end - begin) * GetPageSize());
    }
  }

  std::mutex Mutex;
  std::unordered_map<std::uintptr_t, unsigned> Counts;
};

PerProcess<PageCounts> CountsOfProcess;

} // namespace

void RequestPages(const void* begin, std::size_t size) noexcept
{
  if (size > 0)
  {
    const std::uintptr_t first = PageCounts::PageOf(begin);
    const std::size_t pages =
      PageCounts::PageOf(static_cast<const char*>(begin) + (size - 1)) - first + 1;
    madvise(PageCounts::AddressOf(first), pages * GetPageSize(), MADV_WILLNEED);
  }
}

void FetchPages(const void* begin, std::size_t size) noexcept
{
  if (size == 0)
  {
    return;
  }
  const char* const end = static_cast<const char*>(begin) + size;
#if defined(__linux__)
  const std::uintptr_t first = PageCounts::PageOf(begin);
  const std::size_t pages = PageCounts::PageOf(end - 1) - first + 1;
  // EINVAL: this kernel does not know it. After any other error, reading would crash.
  if (madvise(PageCounts::AddressOf(first), pages * GetPageSize(), PopulateForReading) == 0 ||
    errno != EINVAL)
  {
    return;
  }
#endif
  for (const char* at = static_cast<const char*>(begin); at < end;
       at += std::min(GetPageSize(), static_cast<std::size_t>(end - at)))
  {
    static_cast<void>(*static_cast<const volatile char*>(at));
  }
  static_cast<void>(*static_cast<const volatile char*>(end - 1));
}

MemoryLock::~MemoryLock()
{
  // A forked child does not inherit locks.
  if (this->Process == ServoClock::GetProcess())
  {
    for (const Pages& pages : this->Locked)
    {
      CountsOfProcess.Get().Remove(pages.First, pages.Last);
    }
  }
}

bool MemoryLock::Add(const void* begin, std::size_t size) noexcept
{
  if (size == 0)
  {
    return true;
  }
  const Pages pages{ PageCounts::PageOf(begin),
    PageCounts::PageOf(static_cast<const char*>(begin) + (size - 1)) };
  const std::int64_t process = ServoClock::GetProcess();
  if (this->Process != process)
  {
    this->Process = process;
    this->Locked.clear(); // the locks belong to the parent
  }
  try
  {
    PageCounts& counts = CountsOfProcess.Get();
    this->Locked.push_back(pages);
    const bool granted = counts.Add(pages.First, pages.Last);
    if (!granted)
    {
      this->Locked.pop_back();
    }
    return granted;
  }
  catch (...) // no memory to remember them
  {
    return false;
  }
}

bool MemoryLock::AddStack(std::size_t size) noexcept
{
#if defined(__linux__)
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0)
  {
    return false;
  }
  void* lowest = nullptr;
  std::size_t whole = 0;
  pthread_attr_getstack(&attributes, &lowest, &whole);
  pthread_attr_destroy(&attributes);
  // Stacks grow downwards on every processor of Linux desktops.
  const char* const here = static_cast<const char*>(__builtin_frame_address(0));
  const auto left = static_cast<std::size_t>(here - static_cast<const char*>(lowest));
  const std::size_t locked = std::min(size, left);
  return this->Add(here - locked, locked);
#else
  static_cast<void>(size);
  return false;
#endif
}

#else

std::size_t GetPageSize() noexcept
{
  return 4096;
}

void RequestPages(const void*, std::size_t) noexcept {}

void FetchPages(const void* begin, std::size_t size) noexcept
{
  for (std::size_t at = 0; at < size; at += GetPageSize())
  {
    static_cast<void>(static_cast<const volatile char*>(begin)[at]);
  }
}

MemoryLock::~MemoryLock() = default;

bool MemoryLock::Add(const void*, std::size_t) noexcept
{
  return false;
}

bool MemoryLock::AddStack(std::size_t) noexcept
{
  return false;
}

#endif

} // namespace VolumeHaptics
