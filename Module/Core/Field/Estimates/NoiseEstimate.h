// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Estimates the noise of a volume, and the gradient above which a surface is more than noise.
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
 * Limit of the samples of a volume that is not large: 128 MiB with 16 bits each. Reading all of
 * them takes some ten milliseconds. In a larger volume, only some samples from all over the volume
 * are read, so that neither the time nor the memory of a mapped file grows with the volume.
 */
constexpr std::int64_t MostSamplesRead = std::int64_t{ 1 } << 26;

/** Returns whether a volume is large, that is, has more than MostSamplesRead samples. */
bool IsLargeVolume(const std::int64_t dimensions[3]);

bool IsLargeVolume(const int extent[6]);

/**
 * If a volume has at most this number of samples, its range is computed from all of them: 16 MiB
 * with 16 bits each, which take 10 ms if they are mapped from a file. The range of a larger volume
 * is that of its noise samples.
 */
constexpr std::int64_t MostSamplesRanged = std::int64_t{ 1 } << 23;

bool HasRangeOfAll(const std::int64_t dimensions[3]);

/**
 * Returns the boxes (extents) of a large volume that together contain all noise samples: one for
 * each block, and one for each corner.
 */
std::vector<std::array<int, 6>> ComputeNoiseBoxes(const int whole[6]);

/**
 * A function that returns a sample of a piece of a volume. Its argument is the sample's number, i +
 * n_x (j + n_y k).
 */
using SampleReader = std::function<double(std::int64_t)>;

/**
 * Adds the samples of noise blocks and corners that are in one piece of a volume. The piece has a
 * sample for each index of `extent`, and its indices are those of `whole`. Also merges the range of
 * these samples (NoiseSamples::MergeRange), unless the range is that of all samples
 * (HasRangeOfAll), which the caller merges.
 */
void CollectNoiseSamples(
  const SampleReader& read, const int extent[6], const int whole[6], NoiseSamples& samples);

/**
 * A function that is called with a block of NoiseBlockSide^3 samples. The first index runs fastest.
 */
using BlockVisitor = std::function<void(const double*)>;
constexpr int NoiseBlockSide = 5;

///@{
/**
 * Visits the noise blocks of a volume. There are up to 4096, or 512 in a large volume, evenly
 * spread. Missing samples are infinite.
 */
void VisitNoiseBlocks(const NoiseSamples& samples, const BlockVisitor& visit);
void VisitNoiseBlocks(
  const SampleReader& read, const std::int64_t dimensions[3], const BlockVisitor& visit);
///@}

/**
 * Makes a Finder, adds all noise blocks of a volume to it, and returns its estimate. The arguments
 * describe the volume as for VisitNoiseBlocks.
 */
template <typename Finder, typename... Volume>
auto EstimateInNoiseBlocks(const Volume&... volume)
{
  Finder finder;
  VisitNoiseBlocks(volume..., [&finder](const double* block) { finder.Add(block); });
  return finder.Estimate();
}

/**
 * Estimates the standard deviation of the noise (scalar units). It subtracts the best quadratic
 * from blocks of 5^3 samples, and takes the remainders of the flattest tenth of the noise blocks.
 *
 * Ignores incomplete blocks, and blocks that have only the smallest or the largest value (padding,
 * saturation). Returns 0 if there is no noise, or if the volume has fewer than 5 samples along an
 * axis.
 */
double EstimateNoise(const NoiseSamples& samples);

/**
 * Estimates the same noise, to the bit, for a volume in one piece. It reads block by block and does
 * not copy the samples, because allocating the pages of a copy would take longer than the estimate.
 * `range` is the range of all samples. Unless HasRangeOfAll(), it receives the range of the noise
 * samples; if there are none, its first number is the larger one.
 */
double EstimateNoise(const SampleReader& read, const std::int64_t dimensions[3], double range[2]);

/** Returns the first finite value among the corners of a volume, or 0 if there is none. */
double FindBorderValue(const NoiseSamples& samples);

/**
 * Makes the ramp of distinctness that keeps noise (scalar units) from being felt. The ramp is 0 up
 * to 3.4 sigma_g, which a hundredth of the gradients of pure noise exceed, and 1 from 6.8 sigma_g.
 * sigma_g is the noise of a component of the estimated gradient per world unit, along the axis with
 * the smallest spacing. Along the other axes there is less noise (HapticModel::DistinctnessOf). The
 * ramp is empty if there is no noise.
 */
Polyline MakeNoiseRamp(double noise, const GradientKernel& kernel, const Affine3& indexToWorld);

} // namespace VolumeHaptics

#endif
