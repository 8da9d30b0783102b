// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A range of memory that a tick reads or writes.
 */
#ifndef MemoryRange_h
#define MemoryRange_h

#include <cstddef>

namespace VolumeHaptics
{

struct MemoryRange
{
  const void* Begin = nullptr;
  std::size_t Size = 0; ///< size of the range (bytes)
};

} // namespace VolumeHaptics

#endif
