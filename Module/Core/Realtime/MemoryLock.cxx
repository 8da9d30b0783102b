// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/MemoryLock.h"

#include "Core/Platform/Pages.h"
#include "Core/Realtime/PerProcess.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>

namespace VolumeHaptics
{

std::size_t GetPageSize() noexcept
{
  return Pages::GetSize();
}

namespace
{

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
      if (Pages::Lock(AddressOf(first), (last - first + 1) * GetPageSize()))
      {
        return true;
      }
    }
    catch (...) // there was no memory for the counts
    {
    }
    // The call may have locked some pages of the range, so release them.
    Run run;
    for (std::uintptr_t page = first; page < end; ++page)
    {
      this->Release(page, false, run);
    }
    Unlock(run);
    return false;
  }

  /**
   * Unlocks ranges, which must be in ascending order. If all are in one array, uses as few system
   * calls as possible.
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
   * A run of pages to unlock: pages that have no lock left, and pages between them that were never
   * locked.
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
      Pages::Unlock(AddressOf(run.Begin), (run.End - run.Begin) * GetPageSize()))
    {
      return;
    }
    // The system stops at a page that the program has unmapped, so unlock the pages one by one.
    for (std::uintptr_t page = run.Begin; page < run.End; ++page)
    {
      Pages::Unlock(AddressOf(page), GetPageSize());
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
    Pages::Request(PageCounts::AddressOf(first), pages * GetPageSize());
  }
}

void FetchPages(const void* begin, std::size_t size) noexcept
{
  if (size == 0)
  {
    return;
  }
  const char* const end = static_cast<const char*>(begin) + size;
  const std::uintptr_t first = PageCounts::PageOf(begin);
  const std::size_t pages = PageCounts::PageOf(end - 1) - first + 1;
  if (Pages::Fetch(PageCounts::AddressOf(first), pages * GetPageSize()))
  {
    return;
  }
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
  const Range pages{ PageCounts::PageOf(begin),
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
  const Pages::Stack stack = Pages::FindFreeStack(size);
  return stack.Begin && this->Add(stack.Begin, stack.Size);
}

} // namespace VolumeHaptics
