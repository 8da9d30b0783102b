// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRegionPlanner.h"

#include "Core/Regions/RegionPlan.h"
#include "VTK/Base/WholeFacts.h"
#include "VTK/Regions/HapticRegionSettings.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHapticRegionPlanner);

using namespace VolumeHaptics;

namespace
{
Matrix3 IndexToWorld(const double direction[9], const double spacing[3])
{
  Matrix3 m;
  for (int i = 0; i < 3; ++i)
  {
    m.Row[i] = { direction[3 * i] * spacing[0], direction[3 * i + 1] * spacing[1],
      direction[3 * i + 2] * spacing[2] };
  }
  return m;
}

RegionNeeds NeedsOf(vtkHapticRegionPlanner* p)
{
  RegionNeeds needs;
  needs.MaximumSpeed = p->GetMaximumSpeed() / p->GetMetersPerWorldUnit();
  needs.Latency = p->GetLatency();
  needs.SpringLength = p->GetSpringLength();
  needs.Reach = p->GetReach();
  needs.Band = p->GetBand();
  needs.MostVoxels = static_cast<double>(p->GetMaximumVoxels());
  return needs;
}

WholeGeometry WholeOf(vtkHapticRegionPlanner* planner)
{
  WholeGeometry whole;
  std::copy_n(planner->GetWholeExtent(), 6, whole.Extent);
  whole.IndexToWorld.Linear = IndexToWorld(planner->GetDirection(), planner->GetSpacing());
  const double* const origin = planner->GetOrigin();
  whole.IndexToWorld.Offset = { origin[0], origin[1], origin[2] };
  return whole;
}
} // namespace

//------------------------------------------------------------------------------
bool vtkHapticRegionPlanner::SetWhole(vtkImageData* image)
{
  WholeFacts facts;
  std::string error;
  if (!image || !ReadWholeFacts(image, 0, facts, error))
  {
    vtkErrorMacro(<< (image ? error : "There is no image to take the whole volume from."));
    return false;
  }
  this->SetWholeExtent(facts.IsThere ? facts.Extent : image->GetExtent());
  this->SetOrigin(image->GetOrigin());
  this->SetSpacing(image->GetSpacing());
  this->SetDirection(image->GetDirectionMatrix()->GetData());
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticRegionPlanner::SetDirection(const double direction[9])
{
  if (!direction)
  {
    vtkErrorMacro(
      "Direction needs nine numbers, row by row, but got a null pointer; it stays as it was.");
    return;
  }
  if (!std::equal(direction, direction + 9, this->Direction))
  {
    std::copy(direction, direction + 9, this->Direction);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticRegionPlanner::AddLatency(double seconds)
{
  const double latency = SmoothLatency(this->HasLatency ? this->Latency : seconds, seconds);
  if (seconds >= 0.0 && std::isfinite(seconds))
  {
    this->HasLatency = true;
    this->Latency = std::min(latency, MostLatency);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticRegionPlanner::ResetLatency()
{
  this->HasLatency = false;
  this->Latency = RegionNeeds{}.Latency;
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkHapticRegionPlanner::GetHalfWidth()
{
  return ComputeHalfWidth(NeedsOf(this));
}

//------------------------------------------------------------------------------
bool vtkHapticRegionPlanner::Plan(
  const double tip[3], const double velocity[3], const int resident[6], int wanted[6])
{
  if (!tip || !velocity || !resident || !wanted)
  {
    vtkErrorMacro(
      "Plan() needs a tip, a velocity and two extents of six numbers, but got a null pointer.");
    return false;
  }
  const WholeGeometry whole = WholeOf(this);
  return PlanRegion(whole, NeedsOf(this), { tip[0], tip[1], tip[2] },
    { velocity[0], velocity[1], velocity[2] }, resident, wanted);
}

//------------------------------------------------------------------------------
double vtkHapticRegionPlanner::FindRoom(const double tip[3], const int region[6])
{
  if (!tip || !region)
  {
    vtkErrorMacro("FindRoom() needs a tip and an extent of six numbers, but got a null pointer.");
    return 0.0;
  }
  return ComputeSpareRoom(WholeOf(this), NeedsOf(this), { tip[0], tip[1], tip[2] }, region);
}

//------------------------------------------------------------------------------
void vtkHapticRegionPlanner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintSettings(os, indent, this, PlannerVectors);
  PrintSettings(os, indent, this, PlannerSettings);
  os << indent << "Latency: " << this->Latency << " s\n";
}
