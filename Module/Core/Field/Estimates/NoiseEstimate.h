// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The noise of a volume, and the gradient above which a surface is more than noise.
 */
#ifndef NoiseEstimate_h
#define NoiseEstimate_h

#include "Core/Field/GradientKernel.h"
#include "Core/Field/NoiseSamples.h"
#include "Core/Math/PiecewiseTable.h"
#include "Core/Math/Vector3.h"

#include <array>
#include <functional>
#include <vector>

namespace VolumeHaptics
{

/**
 * The largest number of samples of a volume that is not large: 128 MiB of 16 bits. Reading all of
 * them takes some ten milliseconds; in a large volume only spread samples are read, so that the
 * time does not grow with the volume, nor the memory if it is mapped from a file.
 */
constexpr std::int64_t MostSamplesRead = std::int64_t{ 1 } << 26;

/** Returns whether a volume is large: it has more than MostSamplesRead samples. */
bool IsLargeVolume(const std::int64_t dimensions[3]);

/** Returns whether the volume of an extent is large. */
bool IsLargeVolume(const int extent[6]);

/**
 * The largest number of samples of a volume whose range covers all samples: 16 MiB of 16 bits,
 * which take 10 ms if they are mapped from a file. The range of a larger volume covers its noise
 * samples.
 */
constexpr std::int64_t MostSamplesRanged = std::int64_t{ 1 } << 23;

/** Returns whether the range of a volume covers all samples. */
bool HasRangeOfAll(const std::int64_t dimensions[3]);

/**
 * Computes boxes (extents) of a large volume that together contain all noise samples: a box for
 * each block, and a box for each corner.
 */
std::vector<std::array<int, 6>> ComputeNoiseBoxes(const int whole[6]);

/**
 * A function that returns the sample with a given number, i + n_x (j + n_y k), of a piece of a
 * volume.
 */
using SampleReader = std::function<double(std::int64_t)>;

/**
 * Adds the samples of noise blocks and corners in one piece of a volume. The piece has a sample for
 * every index of `extent`; the indices count as those of `whole`. Merges the range of these samples
 * (NoiseSamples::MergeRange), unless the whole has the range of all samples (HasRangeOfAll), which
 * the caller merges.
 */
void CollectNoiseSamples(
  const SampleReader& read, const int extent[6], const int whole[6], NoiseSamples& samples);

/** A function called with a block of NoiseBlockSide^3 samples; the first index runs fastest. */
using BlockVisitor = std::function<void(const double*)>;
constexpr int NoiseBlockSide = 5;

///@{
/**
 * Visits the noise blocks of a volume: up to 4096 (512 in a large volume), evenly spread. Missing
 * samples are infinite.
 */
void VisitNoiseBlocks(const NoiseSamples& samples, const BlockVisitor& visit);
void VisitNoiseBlocks(
  const SampleReader& read, const std::int64_t dimensions[3], const BlockVisitor& visit);
///@}

/**
 * Passes all noise blocks of a volume to a new Finder and returns the finder's estimate. The
 * arguments give the volume as for VisitNoiseBlocks.
 */
template <typename Finder, typename... Volume>
auto EstimateInNoiseBlocks(const Volume&... volume)
{
  Finder finder;
  VisitNoiseBlocks(volume..., [&finder](const double* block) { finder.Add(block); });
  return finder.Estimate();
}

/**
 * Estimates the standard deviation of the noise (scalar units), from what remains of blocks of 5^3
 * samples after the best quadratic is subtracted, in the flattest tenth of the noise blocks.
 *
 * Blocks that have only the smallest or the largest value (padding, saturation) and incomplete
 * blocks do not count. Returns 0 without noise, and for volumes of less than 5 samples along an
 * axis.
 */
double EstimateNoise(const NoiseSamples& samples);

/**
 * Estimates the same noise, to the bit, for a volume that is not a piece, block by block and
 * without a copy of the samples: allocating the pages of a copy would take longer than the
 * estimate. `range` is the range of all samples or, unless HasRangeOfAll(), receives the range of
 * the noise samples; if there are none, its first number is the larger.
 */
double EstimateNoise(const SampleReader& read, const std::int64_t dimensions[3], double range[2]);

/** Returns the first finite value among the given corners of a volume; 0 if there is none. */
double FindBorderValue(const NoiseSamples& samples);

/**
 * Makes the ramp of distinctness that keeps noise (scalar units) from being felt: 0 up to 3.4
 * sigma_g, which a hundredth of the gradients of pure noise exceed, and 1 from twice that on.
 * sigma_g is the noise of a component of the estimated gradient per world unit, along the axis with
 * the finest spacing; along the other axes the noise is less (HapticModel::DistinctnessOf). The
 * ramp is empty without noise.
 */
Polyline MakeNoiseRamp(double noise, const GradientKernel& kernel, const Affine3& indexToWorld);

} // namespace VolumeHaptics

#endif
