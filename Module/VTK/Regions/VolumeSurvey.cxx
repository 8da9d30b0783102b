// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/VolumeSurvey.h"

#include "Core/Field/Estimates/NoiseEstimate.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace VolumeHaptics
{
namespace
{

constexpr double MostSamplesAtOnce = 1 << 20;

/** Splits an extent into boxes of at most MostSamplesAtOnce. */
void DivideExtent(const BoxExtent& extent, std::vector<BoxExtent>& boxes)
{
  if (CountSamples(extent) <= MostSamplesAtOnce)
  {
    boxes.push_back(extent);
    return;
  }
  // Split along the slowest axis possible, so that rows stay whole.
  const int a = extent[4] < extent[5] ? 4 : extent[2] < extent[3] ? 2 : 0;
  BoxExtent low = extent;
  BoxExtent high = extent;
  low[a + 1] = extent[a] + (extent[a + 1] - extent[a]) / 2;
  high[a] = low[a + 1] + 1;
  DivideExtent(low, boxes);
  DivideExtent(high, boxes);
}

} // namespace

VolumeSurvey::VolumeSurvey(const LargeVolume& volume)
  : Volume(volume)
{
  if (IsLargeVolume(volume.Extent.data()))
  {
    this->Boxes = ComputeNoiseBoxes(volume.Extent.data());
  }
  else
  {
    DivideExtent(volume.Extent, this->Boxes);
  }
}

template <typename T>
void VolumeSurvey::Collect(const BoxExtent& box)
{
  const T* const values = reinterpret_cast<const T*>(this->Bytes.data());
  const int* const whole = this->Volume.Extent.data();
  CollectNoiseSamples([values](std::int64_t i) { return static_cast<double>(values[i]); },
    box.data(), whole, this->Samples);
  if (HasRangeOfAll(this->Samples.Dimensions))
  {
    const auto count = static_cast<std::size_t>(CountSamples(box));
    double range[2] = { 1.0, 0.0 };
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value = static_cast<double>(values[i]);
      if (std::isfinite(value))
      {
        const bool isFirst = range[0] > range[1];
        range[0] = isFirst ? value : std::min(range[0], value);
        range[1] = isFirst ? value : std::max(range[1], value);
        const double both[2] = { value, value };
        if (!MayBeMissing(value))
        {
          NoiseSamples::Extend(this->Samples.Inside, both);
        }
      }
    }
    this->Samples.MergeRange(range);
  }
}

bool VolumeSurvey::Advance(std::string& error)
{
  const BoxExtent& box = this->Boxes[this->Next];
  try
  {
    this->Bytes.resize(static_cast<std::size_t>(CountSamples(box)) * this->Volume.SampleSize);
    if (!ReadSamples(this->Volume, box, this->Bytes.data(), error))
    {
      return false;
    }
    switch (this->Volume.ScalarType)
    {
      vtkTemplateMacro(this->Collect<VTK_TT>(box));
      default:
        break;
    }
  }
  catch (const std::bad_alloc&)
  {
    error = "There is not enough memory to estimate the noise of " + this->Volume.Name + ".";
    return false;
  }
  ++this->Next;
  return true;
}

VolumeFacts VolumeSurvey::GetFacts() const
{
  NoiseSamples filled = this->Samples;
  const OutsideSamples outside = this->Volume.AreLabels ? OutsideSamples{} : DetectOutside(filled);
  FillOutside(outside, filled);
  return { EstimateNoise(filled), FindBorderValue(filled), outside,
    BackgroundLevel::Estimate(filled), StoredShift::Estimate(filled) };
}

} // namespace VolumeHaptics
