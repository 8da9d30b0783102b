// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/BurrInServo.h"

#include "Core/Tools/Burr/BurrTool.h"
#include "Core/Tools/ShellTool.h"
#include "Core/Tools/ToolMemory.h"

namespace VolumeHaptics
{

void StepBurr(
  const HapticModel& model, ServoState& state, ToolMemory& tool, TickRecord& record) noexcept
{
  BurrRecord felt;
  TickBurr(model, { record.Tip, state.IsSpinning, model.Baked->Settings.TickPeriod }, state.Shell,
    state.Burr, { *tool.GetShell(), *tool.GetCarver() }, felt);
  WriteShellRecord(model, state, felt.Shell, record);
  record.Force = felt.Force;
  record.RemovedVolume = felt.RemovedVolume;
  record.IsUnfinished = felt.Shell.IsUnfinished || felt.IsUnfinished;
}

} // namespace VolumeHaptics
