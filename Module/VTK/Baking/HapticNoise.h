// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The noise of a vtkDataArray (NoiseEstimate.h).
 */
#ifndef HapticNoise_h
#define HapticNoise_h

#include "Core/Field/NoiseEstimate.h"
#include "Core/Field/VolumeView.h"

#include "vtkType.h"

#include <array>
#include <tuple>

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Adds the noise samples of one piece of a volume, and its range. The array has a tuple for every
 * index of `extent`; the indices count as those of `whole`.
 */
void CollectNoiseSamples(vtkDataArray* scalars, int component, const int extent[6],
  const int whole[6], NoiseSamples& samples);

/** The noise of the latest scalars; estimated again only after a change. */
class HapticNoise
{
public:
  /** The standard deviation of the noise (scalar units) of a component. */
  double Get(vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component);

private:
  /** The array, the address of its values, their number along each axis, component, last change. */
  using Key = std::tuple<const void*, const void*, std::array<std::int64_t, 3>, int, vtkMTimeType>;

  double Noise = 0.0;
  Key EstimatedFrom{};
};

} // namespace VolumeHaptics

#endif
