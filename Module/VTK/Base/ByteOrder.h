// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The order of the bytes of a number.
 */
#ifndef ByteOrder_h
#define ByteOrder_h

#include <cstdint>

namespace VolumeHaptics
{

/** Whether a byte order (`isBig`: most significant byte first) differs from this computer's. */
inline bool IsOtherByteOrder(bool isBig)
{
  const std::uint16_t probe = 1;
  const bool isHostBig = *reinterpret_cast<const unsigned char*>(&probe) == 0;
  return isBig != isHostBig;
}

} // namespace VolumeHaptics

#endif
