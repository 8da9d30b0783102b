// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Regions/Residency.h"

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/LocalSurface/LocalSurfaceFit.h"
#include "Core/Solvers/Precise/FarSide.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{
namespace
{

/** The reach (world units) of the search for a local surface, except for the ray ahead. */
double LocalDistance(const HapticModel& model) noexcept
{
  return LocalCornerReach * model.Baked->LargestSpacing;
}

/**
 * The reach of a tool with a shape, in addition to the method's: its points around its origin, and
 * their material a kernel length farther.
 */
Vector3 FindToolReach(const HapticModel& model) noexcept
{
  if (!model.Baked->HasShape())
  {
    return {};
  }
  const double reach = model.Baked->Tool->Shell->GetReach() / model.WorldUnitsPerMeter;
  // The foot of a point may move over a voxel, and its gradient reads one more on either side.
  constexpr double around = 3.0;
  return (reach + model.KernelLength) * model.VoxelsPerMeter + Vector3{ around, around, around };
}

Vector3 FindMethodReach(const HapticModel& model) noexcept
{
  const HapticSettings& settings = model.Baked->Settings;
  const Vector3 perUnit = (1.0 / model.WorldUnitsPerMeter) * model.VoxelsPerMeter;
  const double radius = model.Baked->Kernel.Radius;
  const Vector3 spare{ ResidencySpare, ResidencySpare, ResidencySpare };
  const Vector3 kernel = Vector3{ radius, radius, radius } + spare;
  if (settings.Method == HapticMethod::SurfaceProxy)
  {
    return settings.ProxyRadius * perUnit + spare;
  }
  if (settings.Method == HapticMethod::LocalSurface)
  {
    const double bend = radius * model.Baked->LargestSpacing;
    return (LocalDistance(model) + bend) * perUnit + kernel;
  }
  const bool isProxy = settings.Method == HapticMethod::Proxy;
  // At a wall between labels, x_s and x_v are as far away as voxels of the label image are large.
  const double aside = isProxy && model.Baked->FeelsLabels()
    ? std::fmax(model.KernelLength, model.LabelReach)
    : model.KernelLength;
  const Vector3 values = aside * model.VoxelsPerMeter + spare;
  if (settings.Method == HapticMethod::Primitives)
  {
    return Most(values, kernel + Vector3{ 1.0, 1.0, 1.0 }) + Vector3{ ModeWay, ModeWay, ModeWay };
  }
  if (isProxy && settings.Solver == HapticSolver::Precise &&
    settings.Placement == MaterialPlacement::FarSide)
  {
    const double walk = FarSide::FarthestRadii * radius;
    return Most(values, Vector3{ walk, walk, walk } + spare);
  }
  return Most(values, kernel);
}

} // namespace

Vector3 FindReadReach(const HapticModel& model) noexcept
{
  return FindMethodReach(model) + FindToolReach(model);
}

bool FindReadBox(
  const HapticModel& model, const ServoState& state, const Vector3& tip, ReadBox& box) noexcept
{
  const HapticSettings& settings = model.Baked->Settings;
  const bool readsMesh = settings.Method == HapticMethod::SurfaceProxy && !settings.HasIsoSurface;
  // The tick itself handles a tip that is not finite.
  if (readsMesh || !IsFinite(tip))
  {
    return false;
  }
  box.Low = box.High = model.DeviceToIndex(tip);
  box.Margin = FindReadReach(model);
  const auto include = [&](const Vector3& index)
  {
    box.Low = Least(box.Low, index);
    box.High = Most(box.High, index);
  };
  if (state.Enabled && settings.Method != HapticMethod::ForceField)
  {
    include(model.DeviceToIndex(state.Proxy));
    include(model.DeviceToIndex(state.PreviousTip));
    if (settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Precise)
    {
      include(model.DeviceToIndex(state.Precise.ReachedTip));
    }
    if (settings.Method == HapticMethod::LocalSurface)
    {
      const LocalSurfaceRequest& request = state.Local.Request;
      include(model.DeviceToIndex(model.WorldToDevice(request.Position)));
      // The nearest point of a surface ahead may lie on any side.
      const double most = LocalReachAhead * model.Baked->LargestSpacing;
      const double ahead = std::fmin(Norm(request.Ahead), most) - LocalDistance(model);
      box.Margin += (std::fmax(ahead, 0.0) / model.WorldUnitsPerMeter) * model.VoxelsPerMeter;
    }
  }
  return true;
}

double FindResidency(const HapticModel& model, const ServoState& state, const Vector3& tip) noexcept
{
  ReadBox box;
  return !model.Resident.IsWhole() && FindReadBox(model, state, tip, box)
    ? model.Resident.Find(box.Low, box.High, box.Margin)
    : 1.0;
}

} // namespace VolumeHaptics
