// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures how long each call blocks an application's thread while a hand touches a volume, as a
 * function of the volume's size.
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
