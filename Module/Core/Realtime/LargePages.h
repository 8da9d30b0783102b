// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An allocator for arrays of megabytes that are filled right after the allocation.
 */
#ifndef LargePages_h
#define LargePages_h

#include "Core/Platform/Pages.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>

namespace VolumeHaptics
{

/**
 * Allocates in large pages (2 MiB). The system clears small pages (4 KiB) one by one when they are
 * first touched, which takes longer than filling the array.
 */
template <typename T>
struct LargePages
{
  using value_type = T;

  LargePages() = default;
  template <typename U>
  LargePages(const LargePages<U>&) noexcept
  {
  }
  T* allocate(std::size_t count)
  {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    void* const memory = ::operator new(count * sizeof(T), GetAlignment(count));
    if (count * sizeof(T) >= PageSize)
    {
      // The call has no effect if large pages are switched off. If the end of the array does not
      // fill a large page, it stays in small pages.
      Pages::MakeLarge(memory, count * sizeof(T));
    }
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) noexcept
  {
    ::operator delete(memory, GetAlignment(count));
  }
  template <typename U>
  bool operator==(const LargePages<U>&) const noexcept
  {
    return true;
  }
  template <typename U>
  bool operator!=(const LargePages<U>&) const noexcept
  {
    return false;
  }

private:
  static constexpr std::size_t PageSize = std::size_t(2) << 20;

  static std::align_val_t GetAlignment(std::size_t count) noexcept
  {
    return std::align_val_t(
      count * sizeof(T) < PageSize ? alignof(T) : std::max(alignof(T), PageSize));
  }
};

} // namespace VolumeHaptics

#endif
