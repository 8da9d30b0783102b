// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The measurements. Each registration borrows its volume.
 */
#ifndef Benchmarks_h
#define Benchmarks_h

#include "BallVolume.h"

namespace benchmarks
{

/**
 * slide:  along a level of the ball, as a hand does it: what is read is in the cache.
 * random: somewhere else every time, and waiting for each result before the next.
 */
inline std::string NameOf(const std::string& subject, const std::string& variant,
  const std::string& motion, const std::string& volume)
{
  return subject + "/" + variant + "/" + motion + "/" + volume;
}

/** Whole servo ticks: the paper's proxy with each estimator, and the force field. */
void RegisterTickBenchmarks(const BallVolume& volume);

/**
 * Whole ticks in contact with labels on the same grid: a ball of one label in another. The labels
 * give the materials, or the geometry, or both.
 */
void RegisterLabelBenchmarks(const BallVolume& volume);

/** Whole ticks of the methods that touch an isosurface: a mesh, and what a slow loop fits. */
void RegisterSurfaceBenchmarks(const BallVolume& volume);

/** Whole ticks of the method PRIMITIVES: one mode, and four whose primitives are oblique. */
void RegisterModeBenchmarks();

/** Ticks of a tool of 10^4 points, a quarter in contact, and the bare reading of its taps. */
void RegisterShellBenchmarks(const BallVolume& volume);

/**
 * Ticks of a burr of four voxels that slides and removes soft or hard tissue; and of burrs of 16
 * and 30 voxels, if the volume has room for them. With their 99th percentile.
 */
void RegisterBurrBenchmarks(const BallVolume& volume);

/** The offline filter with its trace, beside its ticks alone; by the tick. */
void RegisterFilterBenchmarks(const BallVolume& volume);

/** Measures and prints what a second thread brings to the filter, in real time. */
void PrintThroughput(const BallVolume& volume, bool isQuick);

/** Gradients and values alone, with each instruction set, beside a bare gather of the taps. */
void RegisterFieldBenchmarks(const BallVolume& volume);

/** VTK's own ways to a value and its surroundings. */
void RegisterPeerBenchmarks(const BallVolume& volume);

} // namespace benchmarks

#endif
