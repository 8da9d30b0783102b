// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/RemovalAccess.h"

#include "Core/Carving/TissueImage.h"
#include "Core/Tools/PointShell/BakedShell.h"

#include "vtkDataArray.h"
#include "vtkHapticRemoval.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Number of samples examined. It is small, so that a volume mapped from a file is not read as a
 * whole.
 */
constexpr vtkIdType MostAirSamples = 4096;
/** Fraction of these samples that may be outliers. */
constexpr double AirQuantile = 0.02;

/**
 * Returns the value below which (or, if isLargest, above which) only few of some evenly spread
 * samples lie; 0 if no sample is finite.
 */
double ComputeAir(vtkDataArray* scalars, int component, bool isLargest)
{
  const vtkIdType n = scalars->GetNumberOfTuples();
  const vtkIdType count = std::min(n, MostAirSamples);
  std::vector<double> values;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto at = static_cast<vtkIdType>(
      static_cast<double>(i) * static_cast<double>(n) / static_cast<double>(count));
    const double value = scalars->GetComponent(at, component);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  if (values.empty())
  {
    return 0.0;
  }
  const auto last = static_cast<double>(values.size() - 1);
  const auto place =
    static_cast<std::ptrdiff_t>((isLargest ? 1.0 - AirQuantile : AirQuantile) * last + 0.5);
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

bool IsSameExtent(vtkImageData* image, const int extent[6])
{
  return std::equal(extent, extent + 6, image->GetExtent());
}

/**
 * Computes the index of a volume's first sample in another volume. Returns false if the volume's
 * samples are not at positions of the other volume's samples.
 */
bool DetectShift(vtkImageData* volume, vtkImageData* other, std::int64_t first[3])
{
  constexpr double rounding = 1e-3; // allowed rounding error over the whole volume (voxels)
  const int* const extent = volume->GetExtent();
  const int* const there = other->GetExtent();
  for (int corner = 0; corner < 4; ++corner) // the first sample, then the last one on each axis
  {
    double index[3];
    for (int a = 0; a < 3; ++a)
    {
      index[a] = corner == a + 1 ? std::max(extent[2 * a + 1], extent[2 * a] + 1) : extent[2 * a];
    }
    double world[3];
    double found[3];
    volume->TransformContinuousIndexToPhysicalPoint(index, world);
    other->TransformPhysicalPointToContinuousIndex(world, found);
    for (int a = 0; a < 3; ++a)
    {
      const double at = found[a] - there[2 * a] - (index[a] - extent[2 * a]);
      if (corner == 0)
      {
        first[a] = std::llround(std::clamp(at, -1e9, 1e9));
      }
      // NaN must fail here, too.
      if (!(std::abs(at - static_cast<double>(first[a])) <= rounding))
      {
        return false;
      }
    }
  }
  return true;
}

std::string DescribeExtent(const int extent[6])
{
  std::ostringstream text;
  text << "extent (" << extent[0] << " to " << extent[1] << ", " << extent[2] << " to " << extent[3]
       << ", " << extent[4] << " to " << extent[5] << ")";
  return text.str();
}

} // namespace

RemovalData& RemovalData::Of(vtkHapticRemoval* removal)
{
  return *removal->Data;
}

bool RemovalData::ServeAll() const
{
  bool hasServed = false;
  while (this->Tissue && this->Tissue->Serve())
  {
    hasServed = true;
  }
  return hasServed;
}

void RemovalData::SetFoundAir(vtkHapticRemoval* removal, double value)
{
  removal->AirValue = value;
  removal->Data->HasAir = true;
}

void RemovalData::ApplyContent(std::unique_ptr<RemovalContent> content)
{
  this->Replace(content->Fractions, content->Geometry);
  this->Read = std::move(content);
  this->ReadChanges = this->Tissue->Bricks.GetChanges();
}

bool RemovalData::IsAsRead() const
{
  return this->Read && this->Tissue && this->Tissue->Bricks.GetChanges() == this->ReadChanges;
}

bool RemovalData::IsOtherPart(vtkImageData* geometry, const int extent[6]) const
{
  // If the extents are the same, the volume may have been moved as a whole.
  if (!this->IsAsRead() || IsSameExtent(this->Read->Geometry, extent))
  {
    return false;
  }
  vtkNew<vtkImageData> volume;
  CopyGeometry(geometry, extent, volume);
  std::int64_t first[3];
  return DetectShift(volume, this->Read->Geometry, first) &&
    !std::equal(first, first + 3, this->ReadFirst);
}

bool RemovalData::FitRead(vtkImageData* geometry, const int extent[6])
{
  vtkNew<vtkImageData> volume;
  CopyGeometry(geometry, extent, volume);
  TissueBox box{};
  if (!DetectShift(volume, this->Read->Geometry, box.First))
  {
    return false;
  }
  for (int a = 0; a < 3; ++a)
  {
    box.Size[a] = std::int64_t{ extent[2 * a + 1] } - extent[2 * a] + 1;
  }
  std::unique_ptr<RemovalContent> content = std::move(this->Read);
  const bool isDone = this->Replace(MoveTissue(content->Fractions, box), volume);
  this->Read = std::move(content);
  std::copy(box.First, box.First + 3, this->ReadFirst);
  this->ReadChanges = isDone ? this->Tissue->Bricks.GetChanges() : this->ReadChanges;
  return isDone;
}

bool RemovalData::Replace(const std::vector<BrickTissue>& fractions, vtkImageData* geometry)
{
  auto tissue = std::make_shared<TissueRemoval>();
  if (!WriteBricks(fractions, tissue->Bricks))
  {
    return false;
  }
  this->Tissue = std::move(tissue);
  this->Read = nullptr;
  if (geometry != this->Geometry)
  {
    CopyGeometry(geometry, geometry->GetExtent(), this->Geometry);
  }
  return true;
}

std::shared_ptr<TissueRemoval> GetTissueRemoval(vtkHapticRemoval* removal)
{
  return removal ? RemovalData::Of(removal).Tissue : nullptr;
}

bool HoldRemoval(vtkHapticRemoval* removal, const void* holder)
{
  RemovalData& data = RemovalData::Of(removal);
  if (data.Holder && data.Holder != holder)
  {
    return false;
  }
  data.Holder = holder;
  return true;
}

void LetRemovalGo(vtkHapticRemoval* removal, const void* holder)
{
  RemovalData& data = RemovalData::Of(removal);
  if (data.Holder == holder)
  {
    data.Holder = nullptr;
    if (data.ServeAll())
    {
      removal->Modified();
    }
  }
}

bool DescribeRemoval(vtkHapticRemoval* removal, vtkImageData* geometry, const int extent[6],
  vtkDataArray* scalars, int component, bool isRegion, HapticModelDescription& d,
  std::string& error)
{
  RemovalData& data = RemovalData::Of(removal);
  const bool removes = d.Tool && d.Tool->RemovesTissue();
  const bool isOther =
    data.Tissue && (!IsSameExtent(data.Geometry, extent) || data.IsOtherPart(geometry, extent));
  const bool isFitted = isOther && data.IsAsRead() && data.FitRead(geometry, extent);
  const bool isUsed = data.Tissue &&
    (!data.Tissue->Bricks.IsWhole() || (data.IsAsRead() && !data.Read->Fractions.empty()));
  if (isOther && !isFitted)
  {
    if (isUsed)
    {
      std::ostringstream text;
      text
        << "The removed tissue is of a volume of " << DescribeExtent(data.Geometry->GetExtent())
        << ", and the image on input port 0 has " << DescribeExtent(extent)
        << ". Its file is felt on any part of its volume. Keep it with WriteFile() of the filter's "
           "GetRemoval(), and go on with all tissue after SetRemoval(nullptr).";
      error = text.str();
      return false;
    }
    data.Tissue = nullptr;
    data.Read = nullptr;
    data.HasAir = false;
  }
  if (!d.TimeSteps.empty() || (!removes && !isUsed))
  {
    return true;
  }
  if (!data.Tissue)
  {
    data.Tissue = std::make_shared<TissueRemoval>();
  }
  // Do not compute the air value again while it is in use, because all regions of a volume and the
  // tissue that was removed before must have the same air value.
  if (removal->GetAutoAirValue() && (!data.HasAir || (removes && !isRegion && !isUsed)))
  {
    const auto* const shaped = dynamic_cast<const ShapedTool*>(d.Tool.get());
    const bool isBelow = removes && shaped && shaped->Description.Touch.IsBelow;
    RemovalData::SetFoundAir(removal, ComputeAir(scalars, component, isBelow));
  }
  CopyGeometry(geometry, extent, data.Geometry);
  d.Removal = data.Tissue;
  d.AirValue = removal->GetAirValue();
  return true;
}

} // namespace VolumeHaptics
