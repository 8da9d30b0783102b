// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRegionPlanner.h"

#include "Core/Field/ResidentBox.h"
#include "Core/Model/HapticModel.h"
#include "Core/Regions/RegionPlan.h"
#include "Core/Regions/Residency.h"
#include "Core/Solvers/LocalSurface/LocalSurfaceFit.h"
#include "Core/Solvers/Precise/FarSide.h"
#include "Core/Solvers/Primitives/PrimitiveFollower.h"
#include "VTK/Base/WholeFacts.h"
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Regions/HapticRegionSettings.h"

#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHapticRegionPlanner);

using namespace VolumeHaptics;

namespace
{
/** Longest stretch (m) of the spring by a hand if nothing limits the force. */
constexpr double LongestSpring = 0.05;

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

/**
 * Computes the largest (T_N sqrt(1 + mu^2) + R) / k, in metres. Its largest value lies at a point
 * of the functions.
 */
double FindSpring(vtkVolumeHapticsFilter* filter)
{
  vtkHapticProperty* const property = filter->GetProperty();
  vtkPiecewiseFunction* const k = property->GetStiffness();
  vtkPiecewiseFunction* const functions[] = { k, property->GetSurfaceStrength(),
    property->GetFriction(), property->GetViscosity() };
  const double defaults[] = { 500.0, 2.0, 0.0, 0.0 };
  const auto at = [&](int i, double x)
  { return functions[i]->GetSize() > 0 ? functions[i]->GetValue(x) : defaults[i]; };
  std::vector<double> places = { 0.0 };
  double drag = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int n = 0; n < functions[i]->GetSize(); ++n)
    {
      double node[4];
      functions[i]->GetNodeValue(n, node);
      places.push_back(node[0]);
      drag = i == 3 ? std::max(drag, node[1]) : drag;
    }
  }
  double longest = 0.0;
  for (const double x : places)
  {
    const double own = at(0, x);
    const double stiffness = filter->GetSameShape() ? filter->GetCouplingStiffness() : own;
    const double mu = at(2, x);
    const double force = at(1, x) * std::sqrt(1.0 + mu * mu) + drag;
    longest = std::min(own, stiffness) > HapticModel::MinimumStiffness
      ? std::max(longest, force / stiffness)
      : longest;
  }
  return std::min(longest, LongestSpring);
}

/**
 * Computes the longest spring of PRIMITIVES: all modes pull in the same direction with full
 * strength.
 */
double FindModeSpring(vtkVolumeHapticsFilter* filter)
{
  double force = 0.0; // N
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = filter->GetMode(i);
    if (!mode->GetActive())
    {
      continue;
    }
    if (mode->GetKind() == vtkHapticMode::SURFACE)
    {
      return LongestSpring; // its materials have their own stiffness
    }
    for (const ModeFunction& function : GetModeFunctions(mode))
    {
      double most = function.Default;
      vtkPiecewiseFunction* const strength = function.Function;
      for (int n = 0; n < strength->GetSize(); ++n)
      {
        double node[4];
        strength->GetNodeValue(n, node);
        most = n == 0 ? node[1] : std::max(most, node[1]);
      }
      force += most;
    }
  }
  const double spring = force / filter->GetCouplingStiffness();
  return spring < LongestSpring ? spring : LongestSpring; // also covers a stiffness of 0 N/m
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
void vtkHapticRegionPlanner::UseSettingsOf(vtkVolumeHapticsFilter* filter)
{
  if (!filter)
  {
    vtkErrorMacro("There is no filter to take the settings of.");
    return;
  }
  const Matrix3 toWorld = IndexToWorld(this->Direction, this->Spacing);
  const double voxel = LargestColumn(toWorld);
  const double radius = filter->GetKernelRadius();
  this->SetMetersPerWorldUnit(filter->GetMetersPerWorldUnit());
  const int method = filter->GetMethod();
  const bool isSurface = method == vtkVolumeHapticsFilter::SURFACE_PROXY ||
    method == vtkVolumeHapticsFilter::LOCAL_SURFACE;
  const bool hasModes = method == vtkVolumeHapticsFilter::PRIMITIVES;
  const double spring = isSurface ? LongestSpring
    : hasModes                    ? FindModeSpring(filter)
                                  : FindSpring(filter);
  this->SetSpringLength(spring / this->MetersPerWorldUnit);
  double voxels = radius + ResidencySpare;
  if (hasModes)
  {
    // See Residency.cxx: a derivative's step, and the way that a push may lead.
    voxels += 1.0 + ModeWay;
  }
  else if (method == vtkVolumeHapticsFilter::LOCAL_SURFACE)
  {
    // See Residency.cxx: the corners of the cube in which a surface is searched for, and the reach
    // of its curvature.
    voxels += LocalCornerReach + radius;
  }
  else if (method == vtkVolumeHapticsFilter::PROXY &&
    filter->GetSolver() == vtkVolumeHapticsFilter::PRECISE &&
    filter->GetMaterialPlacement() == vtkVolumeHapticsFilter::FAR_SIDE)
  {
    voxels += (FarSide::FarthestRadii - 1.0) * radius;
  }
  double reach = voxels * voxel;
  auto* const labels = vtkImageData::SafeDownCast(filter->GetInputDataObject(3, 0));
  if (labels && method == vtkVolumeHapticsFilter::PROXY)
  {
    // See Residency.cxx: x_s and x_v of walls between labels.
    const double* const spacing = labels->GetSpacing();
    const double coarsest =
      std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
    reach = std::max(reach, radius * coarsest + ResidencySpare * voxel);
  }
  this->SetReach(
    reach + (method == vtkVolumeHapticsFilter::SURFACE_PROXY ? filter->GetProxyRadius() : 0.0));
  this->SetBand(ResidencyBand * voxel);
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
  return FindHalfWidth(NeedsOf(this));
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
  return FindSpareRoom(WholeOf(this), NeedsOf(this), { tip[0], tip[1], tip[2] }, region);
}

//------------------------------------------------------------------------------
void vtkHapticRegionPlanner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  PrintSettings(os, indent, this, PlannerVectors);
  PrintSettings(os, indent, this, PlannerSettings);
  os << indent << "Latency: " << this->Latency << " s\n";
}
