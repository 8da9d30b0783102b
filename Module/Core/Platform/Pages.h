// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Operations on pages of memory. Addresses and sizes must be multiples of the page size.
 */
#ifndef Pages_h
#define Pages_h

#include <cstddef>

namespace VolumeHaptics
{
namespace Pages
{

std::size_t GetSize() noexcept;

/** Locks pages in memory. If this fails, some of them may be locked. */
bool Lock(void* address, std::size_t size) noexcept;
/** Unlocks pages. If this fails, some of them may still be locked. */
bool Unlock(void* address, std::size_t size) noexcept;
/** Locks all memory of the process, as far as the user's limits allow. */
void LockAll() noexcept;

/** Starts to read pages from the disk, without waiting. */
void Request(void* address, std::size_t size) noexcept;
/**
 * Reads pages into memory, and waits for them. Skips pages that can't be read. Returns false if the
 * system has no such call; the caller may then touch each page.
 */
bool Fetch(void* address, std::size_t size) noexcept;
/** Requests large pages for memory that is about to be written. */
void MakeLarge(void* address, std::size_t size) noexcept;

/** The unused part of the calling thread's stack, at most `size` bytes. */
struct Stack
{
  const char* Begin = nullptr; ///< null if the system does not report it
  std::size_t Size = 0;
};
Stack FindFreeStack(std::size_t size) noexcept;

} // namespace Pages
} // namespace VolumeHaptics

#endif
