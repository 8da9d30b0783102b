// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/HapticNoise.h"

#include "Core/Field/Estimates/OutsideSamples.h"
#include "VTK/Base/SampleRange.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace VolumeHaptics
{
namespace
{

/**
 * Key of a cached noise: the array, the address of its values, their number along each axis, the
 * component, and the modification time. Modification times are unique among all objects, so an
 * object at the address of a deleted one has another key.
 */
using NoiseKey =
  std::tuple<const void*, const void*, std::array<std::int64_t, 3>, int, vtkMTimeType>;

/** Number of cached results; each further result replaces the oldest one. */
constexpr std::size_t MostKnown = 16;

NoiseKey MakeNoiseKey(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component)
{
  const std::int64_t* const n = view.Dimensions;
  // Use the later of both times: programs that write into an array often call only the image's
  // Modified().
  return { scalars, view.Data, { n[0], n[1], n[2] }, component,
    std::max(image->GetMTime(), scalars->GetMTime()) };
}

/**
 * Computes the range of the finite samples without values that mark missing data, from the range of
 * all samples. Reads the samples only if an end of the range may be such a value.
 */
void ComputeInsideRange(vtkDataArray* scalars, int component, double range[2])
{
  const auto isInside = [](double value) { return std::isfinite(value) && !MayBeMissing(value); };
  if (range[0] > range[1] || (isInside(range[0]) && isInside(range[1])))
  {
    return;
  }
  range[0] = 1.0;
  range[1] = 0.0;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = scalars->GetComponent(i, component);
    if (isInside(value))
    {
      const double both[2] = { value, value };
      NoiseSamples::Extend(range, both);
    }
  }
}

/** Returns the cached result for an array. If there is none, calls `find` and caches its result. */
template <typename Found, typename Find>
Found Recall(vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component,
  const Find& find)
{
  struct Known
  {
    NoiseKey Of{};
    Found What;
  };
  thread_local std::array<Known, MostKnown> known;
  thread_local std::size_t next = 0;
  const NoiseKey key = MakeNoiseKey(image, scalars, view, component);
  const auto at =
    std::find_if(known.begin(), known.end(), [&key](const Known& one) { return one.Of == key; });
  if (at != known.end())
  {
    return at->What;
  }
  const Found found = find();
  // Make the key again: `find` may have advanced the modification time, because arrays of other
  // layouts store their computed range in themselves.
  known[next] = { MakeNoiseKey(image, scalars, view, component), found };
  next = (next + 1) % MostKnown;
  return found;
}

} // namespace

void CollectNoiseSamples(vtkDataArray* scalars, int component, const int extent[6],
  const int whole[6], NoiseSamples& samples)
{
  CollectNoiseSamples(
    [=](std::int64_t i) { return scalars->GetComponent(i, component); }, extent, whole, samples);
  if (HasRangeOfAll(samples.Dimensions))
  {
    double range[2];
    ComputeFiniteRange(scalars, component, range);
    samples.MergeRange(range);
    ComputeInsideRange(scalars, component, range);
    NoiseSamples::Extend(samples.Inside, range);
  }
}

FoundNoise EstimateImageNoise(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component)
{
  const auto find = [&]
  {
    FoundNoise noise;
    if (HasRangeOfAll(view.Dimensions))
    {
      ComputeFiniteRange(scalars, component, noise.Range);
    }
    noise.Noise = EstimateNoise([=](std::int64_t i) { return scalars->GetComponent(i, component); },
      view.Dimensions, noise.Range);
    return noise;
  };
  return Recall<FoundNoise>(image, scalars, view, component, find);
}

BackgroundLevel EstimateSolid(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component)
{
  const auto find = [&]
  {
    return BackgroundLevel::Estimate(
      [=](std::int64_t i) { return scalars->GetComponent(i, component); }, view.Dimensions);
  };
  return Recall<BackgroundLevel>(image, scalars, view, component, find);
}

StoredShift EstimateStoredShift(
  vtkImageData* image, vtkDataArray* scalars, const VolumeView& view, int component)
{
  return Recall<StoredShift>(image, scalars, view, component,
    [&] { return EstimateStoredShift(scalars, view.Dimensions, component); });
}

StoredShift EstimateStoredShift(
  vtkDataArray* scalars, const std::int64_t dimensions[3], int component)
{
  return StoredShift::Estimate(
    [=](std::int64_t i) { return scalars->GetComponent(i, component); }, dimensions);
}

} // namespace VolumeHaptics
