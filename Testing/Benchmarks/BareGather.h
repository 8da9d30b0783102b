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

/**
 * A number to which every sample of a cube contributes (the sum of its columns' sums modulo 2^16),
 * given the cube's corner and the distances between lines and between planes.
 */
using Gather = std::int32_t (*)(const std::int16_t* corner, std::int64_t line, std::int64_t plane);

/** For 4, 6 or 8 taps along an axis. */
Gather SelectGather(int taps);

} // namespace benchmarks

#endif
