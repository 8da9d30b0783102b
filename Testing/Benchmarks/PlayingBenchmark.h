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
 * Plays frames of size^3 samples, 20 a second, to a servo at 1 kHz, whose hand rests on a wall, and
 * prints what was missed, beside the same time while the volume is held.
 */
void MeasurePlaying(int size);

} // namespace benchmarks

#endif
