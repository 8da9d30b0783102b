// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares byte orders of numbers.
 */
#ifndef ByteOrder_h
#define ByteOrder_h

#include <cstdint>

namespace VolumeHaptics
{

/**
 * Returns whether a byte order differs from this computer's. `isBig`: the most significant byte
 * comes first.
 */
inline bool IsOtherByteOrder(bool isBig)
{
  const std::uint16_t probe = 1;
  const bool isHostBig = *reinterpret_cast<const unsigned char*>(&probe) == 0;
  return isBig != isHostBig;
}

} // namespace VolumeHaptics

#endif
