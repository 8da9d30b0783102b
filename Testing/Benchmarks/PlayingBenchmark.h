// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures a servo on a moving volume, in real time.
 */
#ifndef PlayingBenchmark_h
#define PlayingBenchmark_h

namespace benchmarks
{

/**
 * Plays time steps of size^3 samples, 20 per second, to a servo at 1 kHz whose hand rests on a
 * wall. Prints how many ticks were skipped, and why. Alternates with a static volume of the same
 * size, and with a loop without a volume.
 *
 * A skipped tick counts as the loop's own fault if its thread computed for longer than a period (by
 * the thread's clock), or waited for a lock or the disk. Otherwise, the machine did not run the
 * thread.
 */
void MeasurePlaying(int size);

} // namespace benchmarks

#endif
