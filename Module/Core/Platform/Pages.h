// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pages of memory. Addresses and sizes are those of whole pages.
 */
#ifndef Pages_h
#define Pages_h

#include <cstddef>

namespace VolumeHaptics
{
namespace Pages
{

/** Returns the size (bytes) of a page. */
std::size_t GetSize() noexcept;

/** Locks pages in memory. If this fails, some of them may be locked. */
bool Lock(void* address, std::size_t size) noexcept;
/** Unlocks pages. If this fails, some of them may still be locked. */
bool Unlock(void* address, std::size_t size) noexcept;
/** Locks all memory of the process, as far as the user may. */
void LockAll() noexcept;

/** Starts to read pages from the disk. */
void Request(void* address, std::size_t size) noexcept;
/**
 * Reads pages into memory, except those that can't be read. Returns false if the system can't do
 * this; the caller may then read each page.
 */
bool Fetch(void* address, std::size_t size) noexcept;
/** Asks for large pages for memory that is about to be written. */
void MakeLarge(void* address, std::size_t size) noexcept;

/** The bytes of the calling thread's stack that are not used yet, at most `size` of them. */
struct Stack
{
  const char* Begin = nullptr; ///< null if the system does not report it
  std::size_t Size = 0;
};
Stack FindFreeStack(std::size_t size) noexcept;

} // namespace Pages
} // namespace VolumeHaptics

#endif
