// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseSolver.h"

#include "Core/Solvers/CarriedProxy.h"
#include "Core/Solvers/Precise/FarSide.h"
#include "Core/Solvers/Precise/PreciseFollower.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Moves the tip to its position, and the proxy according to the law.
 * @param carried distance (m) by which the volume has moved the proxy before
 */
void Solve(const HapticModel& model, const SpringBefore& before, double carried,
  PreciseFollower& follower, TickRecord& record) noexcept
{
  follower.Solve(record.Tip);
  follower.Write(record);
  if (model.Baked->Settings.Placement != MaterialPlacement::Kernel)
  {
    follower.WriteLeap(before, carried, record);
  }
  record.IsUnfinished = follower.IsUnfinished();
}

} // namespace

void StepPrecise(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept
{
  TickMemory* const memory = input.Memory;
  if (!state.Enabled)
  {
    state.Proxy = record.Tip;
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = record.Tip;
  }
  const SpringBefore spring(state);
  // A CarriedProxy is large, so make one only if the volume moves.
  if (!model.Baked->IsMoving() || !state.Enabled)
  {
    PreciseFollower follower(model, state, memory);
    Solve(model, spring, 0.0, follower, record);
    return;
  }
  const Vector3 before = state.Proxy;
  const CarriedProxy carried =
    CarryProxy(model, state, model.Baked->At(state.DataTime, memory), memory);
  record.WallWork = carried.Work;
  if (carried.There)
  {
    const Vector3& tip = state.Precise.ReachedTip;
    const Vector3 lag = tip - before - carried.Shift;
    state.Precise.Spring.Stretch(Norm(lag), Norm(tip - state.Proxy));
  }
  const double distance = Norm(state.Proxy - before);
  PreciseFollower follower(model, state, memory);
  if (carried.There)
  {
    follower.TakeOver(*carried.There, carried.Motion);
  }
  Solve(model, spring, distance, follower, record);
}

Vector3 FindPreciseReach(const HapticModel& model) noexcept
{
  Vector3 around = GetKernelReach(model);
  if (model.Baked->Settings.Placement == MaterialPlacement::FarSide)
  {
    const double walk = FarSide::FarthestRadii * model.Baked->Kernel.Radius;
    around =
      Vector3{ walk, walk, walk } + Vector3{ ResidencySpare, ResidencySpare, ResidencySpare };
  }
  return FindValueReach(model, FindMaterialReach(model), around);
}

void IncludePrecise(const HapticModel& model, const ServoState& state, ReadBox& box) noexcept
{
  box.Include(model.DeviceToIndex(state.Precise.ReachedTip));
}

} // namespace VolumeHaptics
