// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How noisy an image is, and from which gradient on a surface is more than noise.
 */
#ifndef HapticNoise_h
#define HapticNoise_h

#include "Core/Field/NoiseSamples.h"
#include "Core/Model/HapticModel.h"

#include "vtkType.h"

#include <array>
#include <tuple>

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * The standard deviation of the noise (scalar units) of a structured array: what is left of blocks
 * of 5^3 samples when the best quadratic is taken off, in the flattest tenth of some thousand
 * blocks. Blocks that are all the smallest or the largest value (padding, saturation) do not count.
 * 0 where there is no noise, and for images of less than 5 samples along an axis.
 */
double EstimateNoise(vtkDataArray* scalars, const VolumeView& view, int component);

/**
 * The noise of the scalars that were looked at last, estimated once as long as none of what it
 * comes from changes.
 */
class NoiseOfScalars
{
public:
  double Get(vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

private:
  /**
   * The array, where its values are, how many along each axis, the component, and the last change.
   */
  using Key = std::tuple<const void*, const void*, std::array<std::int64_t, 3>, int, vtkMTimeType>;

  double Noise = 0.0;
  Key EstimatedFrom{};
};

/** The same from what all pieces of a volume gave; blocks that are not whole do not count. */
double EstimateNoise(const NoiseSamples& samples);

/** The first finite value among the corners of a volume that were given; 0 where there is none. */
double FindBorderValue(const NoiseSamples& samples);

/**
 * Adds what one piece of a volume holds: samples of noise blocks and corners, and its range. The
 * array has a tuple for every sample of `extent`, whose indices count as those of `whole`.
 */
void CollectSamples(vtkDataArray* scalars, int component, const int extent[6], const int whole[6],
  NoiseSamples& samples);

/**
 * The ramp of distinctness that keeps noise (scalar units) from being felt: 0 up to 3.4 sigma_g,
 * which a hundredth of the gradients of pure noise exceed (Documentation/method.md), 1 from twice
 * that on. sigma_g is the noise of a component of the estimated gradient per world unit, along the
 * axis with the finest spacing. Empty without noise.
 */
Polyline MakeNoiseRamp(double noise, const GradientKernel& kernel, const Affine3& indexToWorld);

} // namespace VolumeHaptics

#endif
