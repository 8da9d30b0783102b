// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps ranges of memory from being paged out while the servo uses them.
 *
 * Only what is named is locked, such as the loop's own memory, and neither program code nor what
 * back ends use: mlockall would read every mapped file of the process from the disk, a volume of
 * gigabytes included. Pages that several locks share stay until the last of them is gone (munlock
 * alone does not count). A forked child has no locks but its own. An application that locks its own
 * memory with mlockall loses that for pages that it shares with these locks.
 *
 * Not in the servo loop: locking may wait for memory.
 */
#ifndef MemoryLock_h
#define MemoryLock_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

class MemoryLock
{
public:
  MemoryLock() = default;
  /** Unlocks all that was added. */
  ~MemoryLock();
  MemoryLock(const MemoryLock&) = delete;
  MemoryLock& operator=(const MemoryLock&) = delete;

  /**
   * Brings a range into memory and keeps it there. False, and nothing locked of it, where that is
   * refused.
   */
  bool Add(const void* begin, std::size_t size) noexcept;
  /**
   * The same for the next `size` bytes of the calling thread's stack: before the thread ends,
   * unlock them.
   */
  bool AddStack(std::size_t size) noexcept;

private:
  struct Pages
  {
    std::uintptr_t First = 0; ///< the number of a page
    std::uintptr_t Last = 0;
  };
  std::vector<Pages> Locked;
  std::int64_t Process = 0; // whose locks they are
};

} // namespace VolumeHaptics

#endif
