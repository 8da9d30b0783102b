// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticNoise.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>

namespace VolumeHaptics
{

void CollectNoiseSamples(vtkDataArray* scalars, int component, const int extent[6],
  const int whole[6], NoiseSamples& samples)
{
  CollectNoiseSamples(
    [=](std::int64_t i) { return scalars->GetComponent(i, component); }, extent, whole, samples);
  double range[2];
  scalars->GetRange(range, component);
  samples.MergeRange(range);
}

double HapticNoise::Get(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component)
{
  const std::int64_t* const n = view.Dimensions;
  // Programs that write into an array often call Modified() of the image only.
  const Key key{ scalars, view.Data, { n[0], n[1], n[2] }, component,
    std::max(image->GetMTime(), scalars->GetMTime()) };
  if (key != this->EstimatedFrom)
  {
    const int extent[6] = { 0, static_cast<int>(n[0] - 1), 0, static_cast<int>(n[1] - 1), 0,
      static_cast<int>(n[2] - 1) };
    NoiseSamples samples;
    CollectNoiseSamples(scalars, component, extent, extent, samples);
    this->Noise = EstimateNoise(samples);
    this->EstimatedFrom = key;
  }
  return this->Noise;
}

} // namespace VolumeHaptics
