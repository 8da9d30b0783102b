// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseSolver.h"

#include "Core/Solvers/CarriedProxy.h"
#include "Core/Solvers/Precise/PreciseFollower.h"

namespace VolumeHaptics
{
namespace
{

void Follow(const HapticModel& model, PreciseFollower& follower, TickRecord& record) noexcept
{
  follower.Follow(record.Tip);
  follower.Write(record);
  if (model.Baked->Settings.Placement != MaterialPlacement::Kernel)
  {
    follower.WriteLeap(record);
  }
  record.IsUnfinished = follower.IsUnfinished();
}

} // namespace

void StepPrecise(
  const HapticModel& model, ServoState& state, TickRecord& record, TickMemory* memory) noexcept
{
  if (!state.Enabled)
  {
    state.Proxy = record.Tip;
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = record.Tip;
  }
  // A CarriedProxy is large: only where the volume moves, a tick makes one.
  if (!model.Baked->IsMoving() || !state.Enabled)
  {
    PreciseFollower follower(model, state, memory);
    Follow(model, follower, record);
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
  PreciseFollower follower(model, state, memory);
  follower.NoteCarried(Norm(state.Proxy - before));
  if (carried.There)
  {
    follower.TakeOver(*carried.There, carried.Motion);
  }
  Follow(model, follower, record);
}

} // namespace VolumeHaptics
