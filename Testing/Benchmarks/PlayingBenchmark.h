// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A volume that moves under a device, in real time.
 */
#ifndef PlayingBenchmark_h
#define PlayingBenchmark_h

namespace benchmarks
{

/**
 * Plays time steps of size^3 samples, 20 a second, to a servo at 1 kHz, whose hand rests on a wall,
 * and prints how many ticks were left out, and why, beside the same while the volume is held, and
 * of a loop without a volume, in turns. A tick counts as the loop's own fault if its thread
 * computed for longer than a period, by the clock of the thread, or waited for a lock or the disk;
 * else the machine did not run it.
 */
void MeasurePlaying(int size);

} // namespace benchmarks

#endif
