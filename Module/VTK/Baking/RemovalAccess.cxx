// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/RemovalAccess.h"

#include "vtkDataArray.h"
#include "vtkHapticRemoval.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** So few that a volume that is mapped from a file is not read as a whole. */
constexpr vtkIdType MostAirSamples = 4096;

/** The least of samples that are spread evenly, or the largest; 0 if none is finite. */
double FindAir(vtkDataArray* scalars, int component, bool isLargest)
{
  const vtkIdType n = scalars->GetNumberOfTuples();
  const vtkIdType count = std::min(n, MostAirSamples);
  double found = std::nan("");
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto at = static_cast<vtkIdType>(
      static_cast<double>(i) * static_cast<double>(n) / static_cast<double>(count));
    const double value = scalars->GetComponent(at, component);
    if (std::isfinite(value))
    {
      found = isLargest ? std::fmax(found, value) : std::fmin(found, value);
    }
  }
  return std::isnan(found) ? 0.0 : found;
}

bool IsSameExtent(vtkImageData* image, const int extent[6])
{
  return std::equal(extent, extent + 6, image->GetExtent());
}

void SetGeometry(vtkImageData* to, vtkImageData* from, const int extent[6])
{
  to->SetExtent(const_cast<int*>(extent));
  to->SetOrigin(from->GetOrigin());
  to->SetSpacing(from->GetSpacing());
  to->SetDirectionMatrix(from->GetDirectionMatrix());
}

} // namespace

RemovalData& RemovalData::Of(vtkHapticRemoval* removal)
{
  return *removal->Data;
}

void RemovalData::SetFoundAir(vtkHapticRemoval* removal, double value)
{
  removal->AirValue = value;
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
    SetGeometry(this->Geometry, geometry, geometry->GetExtent());
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
  }
}

void DescribeRemoval(vtkHapticRemoval* removal, vtkImageData* geometry, const int extent[6],
  vtkDataArray* scalars, int component, bool isRegion, HapticModelDescription& d)
{
  RemovalData& data = RemovalData::Of(removal);
  const bool isBurr = d.Tool.Kind == ToolKind::Burr;
  const bool isSame = data.Tissue && IsSameExtent(data.Geometry, extent);
  if (data.Tissue && !isSame)
  {
    // A hand that still ticks with the old volume keeps its own.
    data.Tissue = nullptr;
  }
  if (!d.Frames.empty() || (!isBurr && (!data.Tissue || data.Tissue->Bricks.IsEmpty())))
  {
    return;
  }
  if (!data.Tissue)
  {
    data.Tissue = std::make_shared<TissueRemoval>();
  }
  // Regions of one volume have one value, and other tools that of the burr.
  if (removal->GetAutoAirValue() && (!isSame || (isBurr && !isRegion)))
  {
    const bool isBelow = isBurr && d.Tool.Shell.Touch.IsBelow;
    RemovalData::SetFoundAir(removal, FindAir(scalars, component, isBelow));
  }
  SetGeometry(data.Geometry, geometry, extent);
  d.Removal = data.Tissue;
  d.AirValue = removal->GetAirValue();
}

} // namespace VolumeHaptics
