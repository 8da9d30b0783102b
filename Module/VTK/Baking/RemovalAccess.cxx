// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/RemovalAccess.h"

#include "VTK/Baking/RemovalFile.h"

#include "vtkDataArray.h"
#include "vtkHapticRemoval.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** So few that a volume that is mapped from a file is not read as a whole. */
constexpr vtkIdType MostAirSamples = 4096;
/** Of them, so many may be outliers. */
constexpr double AirQuantile = 0.02;

/** The value that few samples, spread evenly, are below, or above; 0 if none is finite. */
double FindAir(vtkDataArray* scalars, int component, bool isLargest)
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

bool RemovalData::Replace(const std::vector<BrickShares>& shares, vtkImageData* geometry)
{
  auto tissue = std::make_shared<TissueRemoval>();
  if (!WriteBricks(shares, tissue->Bricks))
  {
    return false;
  }
  this->Tissue = std::move(tissue);
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
  const bool isBurr = d.Tool.Kind == ToolKind::Burr;
  const bool isUsed = data.Tissue && !data.Tissue->Bricks.IsWhole();
  if (data.Tissue && !IsSameExtent(data.Geometry, extent))
  {
    if (isUsed)
    {
      std::ostringstream text;
      text << "The removed tissue is of a volume of " << DescribeExtent(data.Geometry->GetExtent())
           << ", and the image on input port 0 has " << DescribeExtent(extent)
           << ". Keep it with WriteFile() of the filter's GetRemoval(), and go on with all tissue "
              "after SetRemoval(nullptr).";
      error = text.str();
      return false;
    }
    data.Tissue = nullptr;
    data.HasAir = false;
  }
  if (!d.Frames.empty() || (!isBurr && !isUsed))
  {
    return true;
  }
  if (!data.Tissue)
  {
    data.Tissue = std::make_shared<TissueRemoval>();
  }
  // Regions of one volume have one value, and what was removed keeps its own.
  if (removal->GetAutoAirValue() && (!data.HasAir || (isBurr && !isRegion && !isUsed)))
  {
    const bool isBelow = isBurr && d.Tool.Shell.Touch.IsBelow;
    RemovalData::SetFoundAir(removal, FindAir(scalars, component, isBelow));
  }
  CopyGeometry(geometry, extent, data.Geometry);
  d.Removal = data.Tissue;
  d.AirValue = removal->GetAirValue();
  return true;
}

} // namespace VolumeHaptics
