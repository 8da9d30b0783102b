// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/PlannerSettings.h"

#include "Core/Field/ResidentBox.h"
#include "Core/Math/Vector3.h"
#include "Core/Model/HapticModel.h"
#include "Core/Regions/Residency.h"
#include "Core/Solvers/LocalSurface/LocalSurfaceFit.h"
#include "Core/Solvers/Precise/FarSide.h"
#include "Core/Solvers/Primitives/PrimitiveFollower.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Regions/RegionPlanner.h"

#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace VolumeHaptics
{
namespace
{
/**
 * Longest extension (m) of the spring that a hand is expected to cause if nothing limits the force.
 */
constexpr double LongestSpring = 0.05;

/**
 * Computes the largest spring extension (m), (T_N sqrt(1 + mu^2) + R) / k. The maximum occurs at
 * one of the points of the functions.
 */
double ComputeSpring(vtkVolumeHapticsFilter* filter)
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
 * Computes the longest spring extension (m) of PRIMITIVES, with all modes pulling in one direction
 * at full strength.
 */
double ComputeModeSpring(vtkVolumeHapticsFilter* filter)
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
      return LongestSpring; // this mode uses the stiffness of the materials
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
  return spring < LongestSpring ? spring : LongestSpring; // written so that an infinite spring at 0
                                                          // N/m yields LongestSpring
}

} // namespace

//------------------------------------------------------------------------------
void ConfigurePlanner(RegionPlanner& planner, vtkVolumeHapticsFilter* filter)
{
  const double voxel = LargestColumn(planner.GetWhole().IndexToWorld.Linear); // longest edge (m)
  const double radius = filter->GetKernelRadius();
  planner.MetersPerWorldUnit = filter->GetMetersPerWorldUnit();
  const int method = filter->GetMethod();
  const bool isSurface = method == vtkVolumeHapticsFilter::SURFACE_PROXY ||
    method == vtkVolumeHapticsFilter::LOCAL_SURFACE;
  const bool hasModes = method == vtkVolumeHapticsFilter::PRIMITIVES;
  const double spring = isSurface ? LongestSpring
    : hasModes                    ? ComputeModeSpring(filter)
                                  : ComputeSpring(filter);
  planner.SpringLength = spring / filter->GetMetersPerWorldUnit();
  double voxels = radius + ResidencySpare;
  if (hasModes)
  {
    // As in Residency.cxx, include the step of a derivative, and the distance that a push may
    // cover.
    voxels += 1.0 + ModeWay;
  }
  else if (method == vtkVolumeHapticsFilter::LOCAL_SURFACE)
  {
    // As in Residency.cxx, include the corners of the cube that is searched for a surface, and the
    // samples that its curvature needs.
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
    // As in Residency.cxx, include x_s and x_v of walls between labels.
    const double* const spacing = labels->GetSpacing();
    const double coarsest =
      std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
    reach = std::max(reach, radius * coarsest + ResidencySpare * voxel);
  }
  planner.Reach =
    reach + (method == vtkVolumeHapticsFilter::SURFACE_PROXY ? filter->GetProxyRadius() : 0.0);
  planner.Band = ResidencyBand * voxel;
}

} // namespace VolumeHaptics
