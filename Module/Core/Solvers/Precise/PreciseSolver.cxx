// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/PreciseSolver.h"

#include "Core/Solvers/Precise/PreciseFollower.h"

namespace VolumeHaptics
{

void StepPrecise(const HapticModel& model, ServoState& state, TickRecord& record) noexcept
{
  if (!state.Enabled)
  {
    state.Proxy = record.Tip;
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = record.Tip;
  }
  PreciseFollower follower(model, state);
  follower.Follow(record.Tip);
  follower.Write(record);
  record.IsUnfinished = follower.IsUnfinished();
}

} // namespace VolumeHaptics
