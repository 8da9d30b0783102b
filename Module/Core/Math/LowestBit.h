// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions for the lowest bits of a number. KernelInline.h explains why they are inlined.
 */
#ifndef LowestBit_h
#define LowestBit_h

#include "Core/Math/KernelInline.h"

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{
namespace
{

/** Returns the number of the lowest set bit. At least one bit must be set. */
VOLUME_HAPTICS_INLINE int LowestBit(std::uint64_t bits)
{
#if defined(__GNUC__)
  return __builtin_ctzll(bits);
#else
  int bit = 0;
  while (((bits >> bit) & 1U) == 0)
  {
    ++bit;
  }
  return bit;
#endif
}

/** Returns a mask of the lowest `count` bits, 0 to 64. */
VOLUME_HAPTICS_INLINE std::uint64_t FirstBits(std::size_t count)
{
  return count > 0 ? ~std::uint64_t{ 0 } >> (64 - count) : 0;
}

} // namespace
} // namespace VolumeHaptics

#endif
