// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Unique numbers, which distinguish objects even if a new object reuses the memory of an old one.
 */
#ifndef UniqueNumber_h
#define UniqueNumber_h

#include <atomic>
#include <cstdint>

namespace VolumeHaptics
{

/** Returns a number above 0 that no other call has returned. */
inline std::uint64_t MakeUniqueNumber()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

} // namespace VolumeHaptics

#endif
