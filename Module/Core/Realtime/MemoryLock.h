// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps ranges of memory from being paged out while the servo uses them.
 *
 * Only named ranges are locked, such as the loop's own memory. Program code and the memory of back
 * ends are not: mlockall would read every mapped file of the process from the disk, including a
 * volume of gigabytes. Pages that several locks share stay until the last lock is released (munlock
 * alone does not count). A forked child inherits no locks. An application that locks its memory
 * with mlockall loses that lock on pages that these locks share.
 *
 * Do not use it in the servo loop: locking may wait for memory, and fetching pages for the disk.
 */
#ifndef MemoryLock_h
#define MemoryLock_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

std::size_t GetPageSize() noexcept; ///< bytes

/**
 * Starts to read the pages of a range from the disk, and no others, if they are not in memory; does
 * not wait for them.
 */
void RequestPages(const void* begin, std::size_t size) noexcept;
/**
 * Brings the pages of a range into memory, for reading. The call may wait for the disk, but other
 * threads can lock and unlock meanwhile. Skips pages that can't be read, such as the end of a file
 * that was cut.
 */
void FetchPages(const void* begin, std::size_t size) noexcept;

class MemoryLock
{
public:
  MemoryLock() = default;
  /**
   * Makes a lock that unlocks ranges of one array that come in rising order together, with a few
   * system calls instead of hundreds. Pages between these ranges that the application has locked
   * are unlocked, too.
   */
  explicit MemoryLock(bool isOfOneArray)
    : IsOfOneArray(isOfOneArray)
  {
  }
  /** Unlocks all added ranges. */
  ~MemoryLock();
  MemoryLock(const MemoryLock&) = delete;
  MemoryLock& operator=(const MemoryLock&) = delete;

  /**
   * Brings a range into memory and keeps it there. If the system refuses, returns false and locks
   * no part of it.
   */
  bool Add(const void* begin, std::size_t size) noexcept;
  /**
   * Keeps the next `size` bytes of the calling thread's stack in memory, as Add does. Unlock them
   * before the thread ends.
   */
  bool AddStack(std::size_t size) noexcept;

private:
  struct Pages
  {
    std::uintptr_t First = 0; ///< the number of a page
    std::uintptr_t Last = 0;
  };
  std::vector<Pages> Locked;
  bool IsOfOneArray = false;
  std::int64_t Process = 0; // the process that made the locks
};

} // namespace VolumeHaptics

#endif
