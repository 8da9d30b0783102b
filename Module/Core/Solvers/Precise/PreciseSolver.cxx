// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseSolver.h"

#include "Core/Solvers/CarriedProxy.h"
#include "Core/Solvers/Precise/PreciseFollower.h"

namespace VolumeHaptics
{

void StepPrecise(
  const HapticModel& model, ServoState& state, TickRecord& record, TapMemory* memory) noexcept
{
  if (!state.Enabled)
  {
    state.Proxy = record.Tip;
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = record.Tip;
  }
  CarriedProxy carried;
  if (model.Baked->IsMoving() && state.Enabled)
  {
    const Vector3 before = state.Proxy;
    carried = CarryProxy(model, state);
    const Vector3& tip = state.Precise.ReachedTip;
    if (carried.IsChanged)
    {
      const Vector3 lag = tip - before - carried.Shift;
      state.Precise.Spring.Stretch(Norm(lag), Norm(tip - state.Proxy));
    }
    record.WallWork = carried.Work;
  }
  PreciseFollower follower(model, state, memory);
  if (carried.IsChanged)
  {
    follower.TakeOver(carried);
  }
  follower.Follow(record.Tip);
  follower.Write(record);
  record.IsUnfinished = follower.IsUnfinished();
}

} // namespace VolumeHaptics
