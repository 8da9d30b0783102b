// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An allocator for tables that are read as vectors.
 */
#ifndef CacheLines_h
#define CacheLines_h

#include <cstddef>
#include <limits>
#include <new>

namespace VolumeHaptics
{

/**
 * Allocates memory that begins at a cache line, because reading a vector that crosses into the next
 * line takes two reads.
 */
template <typename T>
struct CacheLines
{
  using value_type = T;

  CacheLines() = default;
  template <typename U>
  CacheLines(const CacheLines<U>&) noexcept
  {
  }
  T* allocate(std::size_t count)
  {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    return static_cast<T*>(::operator new(count * sizeof(T), Line));
  }
  void deallocate(T* memory, std::size_t) noexcept { ::operator delete(memory, Line); }
  template <typename U>
  bool operator==(const CacheLines<U>&) const noexcept
  {
    return true;
  }
  template <typename U>
  bool operator!=(const CacheLines<U>&) const noexcept
  {
    return false;
  }

private:
  static constexpr std::align_val_t Line{ 64 }; ///< bytes of a cache line
};

} // namespace VolumeHaptics

#endif
