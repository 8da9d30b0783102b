// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the byte order of a file with that of this computer.
 */
#ifndef ByteOrder_h
#define ByteOrder_h

#include <cstdint>

namespace VolumeHaptics
{

/**
 * Returns whether numbers need their bytes swapped on this computer. `isBig`: the numbers are
 * big-endian.
 */
inline bool IsOtherByteOrder(bool isBig)
{
  const std::uint16_t probe = 1;
  const bool isHostBig = *reinterpret_cast<const unsigned char*>(&probe) == 0;
  return isBig != isHostBig;
}

} // namespace VolumeHaptics

#endif
