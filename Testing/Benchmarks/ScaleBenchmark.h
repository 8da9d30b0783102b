// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How long each call of an application keeps its thread busy while a volume of any size is felt.
 */
#ifndef ScaleBenchmark_h
#define ScaleBenchmark_h

namespace benchmarks
{

/**
 * Prints, for cubes of 256^3 samples up to `largest`^3 in memory-mapped files, the longest time of
 * each call, its growth with the size, and how much of the volume it makes resident. Returns
 * whether a call took longer than 50 ms.
 */
bool MeasureScale(int largest);

} // namespace benchmarks

#endif
