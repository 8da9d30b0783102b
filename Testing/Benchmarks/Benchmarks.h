// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Registers the benchmarks. Each benchmark refers to its volume, which must outlive it.
 */
#ifndef Benchmarks_h
#define Benchmarks_h

#include "BallVolume.h"

namespace benchmarks
{

/**
 * Returns the name of a benchmark. The motion is one of:
 * slide:  along a level of the ball, as a hand moves; the samples are in the cache.
 * random: to a random position each time, which depends on the previous result.
 */
inline std::string NameOf(const std::string& subject, const std::string& variant,
  const std::string& motion, const std::string& volume)
{
  return subject + "/" + variant + "/" + motion + "/" + volume;
}

/** Registers whole servo ticks: the paper's proxy with each estimator, and the force field. */
void RegisterTickBenchmarks(const BallVolume& volume);

/**
 * Registers whole ticks in contact with labels on the same grid: a ball of one label in another.
 * The labels give the materials, the geometry, or both.
 */
void RegisterLabelBenchmarks(const BallVolume& volume);

/**
 * Registers whole ticks of the methods that touch an isosurface: a mesh, and the local surface that
 * a slow loop fits.
 */
void RegisterSurfaceBenchmarks(const BallVolume& volume);

/**
 * Registers whole ticks of the method PRIMITIVES: one mode, and four modes with oblique primitives.
 */
void RegisterModeBenchmarks();

/**
 * Registers ticks of a tool of 10^4 points, a quarter of them in contact. For comparison, registers
 * only the reading of the samples that these ticks use.
 */
void RegisterShellBenchmarks(const BallVolume& volume);

/**
 * Registers ticks of a burr of four voxels that slides and removes soft or hard tissue and, if the
 * volume is large enough, of burrs of 16 and 30 voxels. The results include the 99th percentile.
 */
void RegisterBurrBenchmarks(const BallVolume& volume);

/** Registers the offline filter with its trace, and its bare ticks; times are per tick. */
void RegisterFilterBenchmarks(const BallVolume& volume);

/** Measures and prints the filter's gain from a second thread, in wall-clock time. */
void PrintThroughput(const BallVolume& volume, bool isQuick);

/**
 * Registers gradients and values without a tick, with each instruction set, and a bare reading of
 * the taps.
 */
void RegisterFieldBenchmarks(const BallVolume& volume);

/** Registers VTK's functions that return a value and its neighbourhood. */
void RegisterPeerBenchmarks(const BallVolume& volume);

} // namespace benchmarks

#endif
