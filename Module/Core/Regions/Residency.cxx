// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Regions/Residency.h"

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Methods/Methods.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Computes how far a shaped tool reads beyond the method's own reach. It is the largest distance of
 * its points from its origin plus a kernel length, because the material is read around each point.
 */
Vector3 ComputeToolReach(const HapticModel& model) noexcept
{
  const BakedTool* const tool = model.Baked->Tool.get();
  if (!tool || tool->GetReach() < 0.0)
  {
    return {};
  }
  const double reach = tool->GetReach() / model.WorldUnitsPerMeter;
  // The foot of a point may move by one voxel, and its gradient reads one more voxel on each side.
  constexpr double around = 3.0;
  return (reach + model.KernelLength) * model.VoxelsPerMeter + Vector3{ around, around, around };
}

} // namespace

Vector3 ComputeReadReach(const HapticModel& model) noexcept
{
  return GetMethod(model.Baked->Settings).Reach(model) + ComputeToolReach(model);
}

bool ComputeReadBox(
  const HapticModel& model, const ServoState& state, const Vector3& tip, ReadBox& box) noexcept
{
  const HapticSettings& settings = model.Baked->Settings;
  const bool readsMesh = settings.Method == HapticMethod::SurfaceProxy && !settings.HasIsoSurface;
  // A tip that is not finite is handled by the tick itself.
  if (readsMesh || !IsFinite(tip))
  {
    return false;
  }
  box.Low = box.High = model.DeviceToIndex(tip);
  box.Margin = ComputeReadReach(model);
  const Method& method = GetMethod(settings);
  if (state.Enabled && method.HasProxy)
  {
    box.Include(model.DeviceToIndex(state.Proxy));
    box.Include(model.DeviceToIndex(state.PreviousTip));
    if (method.Include)
    {
      method.Include(model, state, box);
    }
  }
  return true;
}

double ComputeResidency(
  const HapticModel& model, const ServoState& state, const Vector3& tip) noexcept
{
  ReadBox box;
  return !model.Resident.IsWhole() && ComputeReadBox(model, state, tip, box)
    ? model.Resident.Compute(box.Low, box.High, box.Margin)
    : 1.0;
}

} // namespace VolumeHaptics
