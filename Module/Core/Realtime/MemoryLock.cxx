// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/MemoryLock.h"

#include "Core/Realtime/PerProcess.h"

#if defined(__unix__)
#include <algorithm>
#include <cerrno>
#include <iterator>
#include <map>
#include <mutex>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>
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
/** MADV_POPULATE_READ of Linux 5.14, which older headers do not define. */
constexpr int PopulateForReading = 22;
#endif

/** Counts how many locks each page of a process has. */
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
    std::uintptr_t end = first; // end of the pages that were counted
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
    catch (...) // there was no memory for the counts
    {
    }
    // mlock may have locked some pages of the range. Release them.
    Run run;
    for (std::uintptr_t page = first; page < end; ++page)
    {
      this->Release(page, false, run);
    }
    Unlock(run);
    return false;
  }

  /**
   * Unlocks ranges in ascending order. If they are of one array, uses as few system calls as
   * possible.
   */
  template <typename Ranges>
  void Remove(const Ranges& ranges, bool areOfOneArray) noexcept
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    Run run;
    for (const auto& range : ranges)
    {
      for (std::uintptr_t page = range.First; page <= range.Last; ++page)
      {
        this->Release(page, areOfOneArray, run);
      }
    }
    Unlock(run);
  }

  static void* AddressOf(std::uintptr_t page) noexcept
  {
    return reinterpret_cast<void*>(page * GetPageSize());
  }

private:
  /**
   * A run of pages to unlock: pages without a lock, and pages between them that were never locked.
   */
  struct Run
  {
    std::uintptr_t Begin = 0;
    std::uintptr_t End = 0;
  };

  void Release(std::uintptr_t page, bool isOfArray, Run& run) noexcept
  {
    const auto found = this->Counts.find(page);
    if (found == this->Counts.end() || --found->second > 0)
    {
      return;
    }
    const auto next = this->Counts.erase(found);
    const bool goesOn = run.Begin < run.End && run.End <= page &&
      (run.End == page ||
        (isOfArray && (next == this->Counts.begin() || std::prev(next)->first < run.Begin)));
    if (!goesOn)
    {
      Unlock(run);
      run.Begin = page;
    }
    run.End = page + 1;
  }
  static void Unlock(const Run& run) noexcept
  {
    if (run.Begin >= run.End ||
      munlock(AddressOf(run.Begin), (run.End - run.Begin) * GetPageSize()) == 0)
    {
      return;
    }
    // If the program has unmapped a page, munlock stops there, so unlock the pages one by one.
    for (std::uintptr_t page = run.Begin; page < run.End; ++page)
    {
      munlock(AddressOf(page), GetPageSize());
    }
  }

  std::mutex Mutex;
  std::map<std::uintptr_t, unsigned> Counts;
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
  // EINVAL means that this kernel lacks MADV_POPULATE_READ. After any other error, reading the
  // pages would crash.
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
    CountsOfProcess.Get().Remove(this->Locked, this->IsOfOneArray);
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
    this->Locked.clear(); // a forked child does not inherit the parent's locks
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
  catch (...) // there was no memory for the list
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
  // The stack grows downwards on all processors for which this code is compiled.
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
