// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The least that a gradient can cost: reading its taps.
 */
#ifndef BareGather_h
#define BareGather_h

#include <cstdint>

namespace benchmarks
{

/** The plain sum of a cube of int16 samples, given its corner and the distance of lines, planes. */
using Gather = std::int32_t (*)(
  const std::int16_t* corner, std::int64_t line, std::int64_t plane);

/** For 4, 6 or 8 taps along an axis. */
Gather SelectGather(int taps);

} // namespace benchmarks

#endif
