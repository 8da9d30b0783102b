// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Locks ranges of memory, so that the system does not page them out while the servo uses them.
 *
 * Only given ranges are locked, such as the loop's own memory. Program code and the memory of back
 * ends are not locked, because mlockall would read every mapped file of the process from the disk,
 * even a volume of gigabytes. The system does not count locks, but this class does: a page in
 * several locks stays locked until the last of them is released. A forked child inherits no locks.
 * If an application has locked its memory with mlockall, it loses that lock on pages that are also
 * locked here.
 *
 * Must not be used in the servo loop: locking may wait for memory, and fetching pages may wait for
 * the disk.
 */
#ifndef MemoryLock_h
#define MemoryLock_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

std::size_t GetPageSize() noexcept;

/**
 * Starts to read the pages of a range that are not in memory from the disk. Does not wait for them.
 */
void RequestPages(const void* begin, std::size_t size) noexcept;
/**
 * Reads the pages of a range into memory. May wait for the disk; meanwhile, other threads can lock
 * and unlock. Skips pages that can't be read, such as the end of a truncated file.
 */
void FetchPages(const void* begin, std::size_t size) noexcept;

class MemoryLock
{
public:
  MemoryLock() = default;
  /**
   * Makes a lock. If isOfOneArray is true, all ranges must be in one array and be added in
   * ascending order; unlocking them then needs a few system calls instead of hundreds, but also
   * unlocks pages between them that the application has locked.
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
   * Reads a range into memory and locks it. Returns false and locks nothing if the system refuses.
   */
  bool Add(const void* begin, std::size_t size) noexcept;
  /**
   * Locks the next `size` bytes of the calling thread's stack, like Add(). They must be unlocked
   * before the thread ends.
   */
  bool AddStack(std::size_t size) noexcept;

private:
  struct Range
  {
    std::uintptr_t First = 0; ///< number of the first page
    std::uintptr_t Last = 0;
  };
  std::vector<Range> Locked;
  bool IsOfOneArray = false;
  std::int64_t Process = 0; // process that made the locks
};

} // namespace VolumeHaptics

#endif
