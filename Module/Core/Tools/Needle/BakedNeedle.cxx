// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Needle/BakedNeedle.h"

#include "Core/Tools/Needle/NeedleEntry.h"
#include "Core/Tools/Needle/NeedleTool.h"

#include <utility>

namespace VolumeHaptics
{

BakedNeedle::BakedNeedle(NeedleDescription description)
  : Description(std::move(description))
  , Forces({ this->Description.ShaftFriction, this->Description.CuttingForce })
{
}

const ToolColumns& BakedNeedle::Columns()
{
  // Never destroyed, because a filter may live until the process ends.
  static const auto* const columns = new ToolColumns{ { "ForbiddenTouches", "", 1, false,
    [](const HapticModel&, const TickRecord& record, double* numbers)
    { numbers[0] = record.ToolNumbers[0]; } } };
  return *columns;
}

bool BakedNeedle::IsSame(const BakedTool& other) const
{
  const auto* const needle = dynamic_cast<const BakedNeedle*>(&other);
  const NeedleDescription& a = this->Description;
  return needle && IsSameLine(a.ShaftFriction, needle->Description.ShaftFriction) &&
    IsSameLine(a.CuttingForce, needle->Description.CuttingForce) &&
    a.HasCuttingForce == needle->Description.HasCuttingForce &&
    a.LateralStrength == needle->Description.LateralStrength;
}

bool BakedNeedle::Step(const ToolTick& tick) const noexcept
{
  ServoState& state = tick.State;
  if (state.Needle.IsInserted)
  {
    StepNeedle(tick.Model, state, tick.Record);
  }
  else
  {
    const FreeTick before(state);
    const bool isFelt = state.Enabled;
    tick.FeelPoint();
    if (isFelt)
    {
      EnterNeedle(tick.Model, state, before, tick.Record);
    }
  }
  tick.Record.ToolNumbers[0] = state.Needle.Touches;
  return state.Needle.IsInserted;
}

bool BakedNeedle::Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
  ToolMemory* /*memory*/) const noexcept
{
  const bool wasInserted = state.Needle.IsInserted;
  CarryNeedle(from, to, state.Needle);
  return wasInserted && !state.Needle.IsInserted;
}

void BakedNeedle::AppendTables(std::vector<MemoryRange>& tables) const
{
  tables.push_back({ this, sizeof(*this) });
  tables.push_back(
    { this->Forces.GetMemory(), this->Forces.GetMemorySize() - sizeof(this->Forces) });
}

} // namespace VolumeHaptics
