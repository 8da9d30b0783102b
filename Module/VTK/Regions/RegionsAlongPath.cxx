// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/RegionsAlongPath.h"

#include "Core/Model/HapticModel.h"
#include "Core/Regions/Residency.h"
#include "Core/State/ServoState.h"

#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Usual number of samples in a region, which takes some milliseconds to read and lasts for hundreds
 * of ticks.
 */
constexpr double UsualSamples = 1 << 20;
/** Largest number of samples in a region (256 MiB at 16 bits), for a tip that jumps. */
constexpr double MostSamplesOfRegion = 1 << 27;
/** Smallest width (samples) of a region, so that the largest kernel fits into it. */
constexpr double LeastWidth = 2.0 * 16.0 + 1.0;

/**
 * Range of sample indices (from 0) within a distance of the positions of a tick, along an axis with
 * n samples.
 */
struct AxisSpan
{
  AxisSpan(double low, double high, double margin, double n)
  {
    const double least = std::max(LeastWidth - 1.0 - (high - low), 0.0) / 2.0;
    const double reach = std::max(margin, least);
    this->First = std::clamp(std::floor(low - reach), 0.0, n - 1.0);
    this->Last = std::clamp(std::ceil(high + reach), 0.0, n - 1.0);
    // Outside the volume, a tick reads the samples at the border.
    this->First = std::max(std::min(this->First, this->Last - LeastWidth + 1.0), 0.0);
    this->Last = std::min(std::max(this->Last, this->First + LeastWidth - 1.0), n - 1.0);
  }
  double GetCount() const { return this->Last - this->First + 1.0; }

  double First;
  double Last;
};

/**
 * Makes a region from a box, the margin that a full residency needs, and `spare` voxels around
 * both. Returns the number of samples.
 */
double MakeRegion(const ReadBox& box, double spare, const int whole[6], int region[6])
{
  const double low[3] = { box.Low.X, box.Low.Y, box.Low.Z };
  const double high[3] = { box.High.X, box.High.Y, box.High.Z };
  const double margin[3] = { box.Margin.X, box.Margin.Y, box.Margin.Z };
  double count = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    const double n = static_cast<double>(whole[2 * a + 1]) - whole[2 * a] + 1.0;
    const AxisSpan span(low[a], high[a], margin[a] + ResidencyBand + spare, n);
    region[2 * a] = whole[2 * a] + static_cast<int>(span.First);
    region[2 * a + 1] = whole[2 * a] + static_cast<int>(span.Last);
    count *= span.GetCount();
  }
  return count;
}

/**
 * Computes the largest region around the box with at most UsualSamples; if even the smallest region
 * has more, computes that one.
 */
double ComputeRegion(const ReadBox& box, const int whole[6], int region[6])
{
  constexpr double most = 256.0; // largest number of spare voxels
  double low = 1.0;
  double high = most;
  while (high - low > 1.0)
  {
    const double middle = std::floor(0.5 * (low + high));
    (MakeRegion(box, middle, whole, region) > UsualSamples ? high : low) = middle;
  }
  return MakeRegion(box, low, whole, region);
}

} // namespace

RegionsAlongPath::RegionsAlongPath(vtkHapticRegionSource* source, Baker bake)
  : Source(source)
  , Bake(std::move(bake))
{
}

std::shared_ptr<const HapticModel> RegionsAlongPath::Read(const int region[6]) const
{
  const vtkNew<vtkImageData> image;
  std::string error;
  auto model = this->Source->ReadRegion(region, image, error) ? this->Bake(image, error) : nullptr;
  if (!model)
  {
    throw RegionLost(error);
  }
  return model;
}

std::shared_ptr<const HapticModel> RegionsAlongPath::Begin() const
{
  int region[6];
  MakeRegion(ReadBox{}, 0.0, this->Source->GetWholeExtent(), region);
  return this->Read(region);
}

std::shared_ptr<const HapticModel> RegionsAlongPath::Find(
  std::shared_ptr<const HapticModel> model, const ServoState& state, const Vector3& tip) const
{
  ReadBox box;
  if (ComputeResidency(*model, state, tip) == 1.0 || !ComputeReadBox(*model, state, tip, box))
  {
    return model;
  }
  int region[6];
  if (ComputeRegion(box, this->Source->GetWholeExtent(), region) > MostSamplesOfRegion)
  {
    throw RegionLost("The tip jumps so far in one tick that the samples between are more than "
                     "2^27. Give the path more points, or a point array \"Time\" with later "
                     "times.");
  }
  auto found = this->Read(region);
  if (ComputeResidency(*found, state, tip) < 1.0)
  {
    throw RegionLost("The samples of a tick are not in the region that was read for it.");
  }
  return found;
}

} // namespace VolumeHaptics
