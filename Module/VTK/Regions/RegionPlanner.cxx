// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/RegionPlanner.h"

#include "VTK/Base/WholeFacts.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

void RegionPlanner::SetWhole(
  const int extent[6], const double origin[3], const double spacing[3], const double direction[9])
{
  std::copy_n(extent, 6, this->Whole.Extent);
  for (int i = 0; i < 3; ++i)
  {
    this->Whole.IndexToWorld.Linear.Row[i] = { direction[3 * i] * spacing[0],
      direction[3 * i + 1] * spacing[1], direction[3 * i + 2] * spacing[2] };
  }
  this->Whole.IndexToWorld.Offset = { origin[0], origin[1], origin[2] };
}

bool RegionPlanner::SetWhole(vtkImageData* image, std::string& error)
{
  WholeFacts facts;
  if (!ReadWholeFacts(image, 0, facts, error))
  {
    return false;
  }
  this->SetWhole(facts.IsThere ? facts.Extent : image->GetExtent(), image->GetOrigin(),
    image->GetSpacing(), image->GetDirectionMatrix()->GetData());
  return true;
}

void RegionPlanner::SetMaximumVoxels(vtkIdType voxels)
{
  constexpr vtkIdType most = 134217728;
  this->MaximumVoxels = std::clamp(voxels, static_cast<vtkIdType>(LeastVoxels), most);
}

void RegionPlanner::AddLatency(double seconds)
{
  const double latency = SmoothLatency(this->HasLatency ? this->Latency : seconds, seconds);
  if (seconds >= 0.0 && std::isfinite(seconds))
  {
    this->HasLatency = true;
    this->Latency = std::min(latency, MostLatency);
  }
}

void RegionPlanner::ResetLatency()
{
  this->HasLatency = false;
  this->Latency = RegionNeeds{}.Latency;
}

RegionNeeds RegionPlanner::ComputeNeeds() const
{
  RegionNeeds needs;
  needs.MaximumSpeed = this->MaximumSpeed / this->MetersPerWorldUnit;
  needs.Latency = this->Latency;
  needs.SpringLength = this->SpringLength;
  needs.Reach = this->Reach;
  needs.Band = this->Band;
  needs.MostVoxels = static_cast<double>(this->MaximumVoxels);
  return needs;
}

double RegionPlanner::GetHalfWidth() const
{
  return ComputeHalfWidth(this->ComputeNeeds());
}

bool RegionPlanner::Plan(
  const double tip[3], const double velocity[3], const int resident[6], int wanted[6]) const
{
  return PlanRegion(this->Whole, this->ComputeNeeds(), { tip[0], tip[1], tip[2] },
    { velocity[0], velocity[1], velocity[2] }, resident, wanted);
}

double RegionPlanner::ComputeRoom(const double tip[3], const int region[6]) const
{
  return ComputeSpareRoom(this->Whole, this->ComputeNeeds(), { tip[0], tip[1], tip[2] }, region);
}

} // namespace VolumeHaptics
