// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps ranges of memory from being paged out while the servo uses them.
 *
 * Only named ranges are locked, such as the loop's own memory. Program code and the memory of back
 * ends are not: mlockall would read every mapped file of the process from the disk, including a
 * volume of gigabytes. Pages that several locks share stay until the last lock is released (munlock
 * alone does not count). A forked child only has locks of its own. An application that locks its
 * memory with mlockall loses that lock on pages that it shares with these.
 *
 * Not in the servo loop: locking may wait for memory, and bringing pages in for the disk.
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
 * Begins to read the pages of a range from the disk, and nothing beside it, if they are not in
 * memory; does not wait for them.
 */
void RequestPages(const void* begin, std::size_t size) noexcept;
/**
 * Brings the pages of a range into memory, for reading. It may wait for the disk, but lets other
 * threads lock and unlock meanwhile. What can't be read, such as the end of a file that was cut,
 * is passed over.
 */
void FetchPages(const void* begin, std::size_t size) noexcept;

class MemoryLock
{
public:
  MemoryLock() = default;
  /**
   * If all ranges are of one array and come in rising order, they are unlocked together, which
   * takes a few calls of the system instead of hundreds. What the application itself has locked
   * between them is then unlocked, too.
   */
  explicit MemoryLock(bool isOfOneArray)
    : IsOfOneArray(isOfOneArray)
  {
  }
  /** Unlocks all that was added. */
  ~MemoryLock();
  MemoryLock(const MemoryLock&) = delete;
  MemoryLock& operator=(const MemoryLock&) = delete;

  /**
   * Brings a range into memory and keeps it there. If that is refused, returns false and locks
   * nothing of it.
   */
  bool Add(const void* begin, std::size_t size) noexcept;
  /**
   * The same for the next `size` bytes of the calling thread's stack. Unlock them before the thread
   * ends.
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
