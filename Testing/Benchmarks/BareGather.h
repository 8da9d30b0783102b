// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the smallest possible cost of a gradient: reading its taps.
 */
#ifndef BareGather_h
#define BareGather_h

#include <cstdint>

namespace benchmarks
{

/**
 * Returns a number to which each sample of a cube contributes: the sum of the columns' sums modulo
 * 2^16. The arguments are the cube's corner, and the distances between lines and between planes (in
 * samples).
 */
using Gather = std::int32_t (*)(const std::int16_t* corner, std::int64_t line, std::int64_t plane);

/** Returns the function for 4, 6 or 8 taps along each axis. */
Gather SelectGather(int taps);

} // namespace benchmarks

#endif
