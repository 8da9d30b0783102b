// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Burr/BakedBurr.h"

#include "Core/State/ServoState.h"
#include "Core/Tools/Burr/BurrTool.h"

#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr double FullTurn = 2.0 * 3.14159265358979323846;

double ComputeFrequency(double speed)
{
  double frequency = speed;
  while (frequency > BakedBurr::MostFrequency && frequency < HUGE_VAL)
  {
    frequency *= 0.5;
  }
  return frequency < HUGE_VAL ? frequency : 0.0;
}

/** The memory of a burr's head and of its carver. */
class BurrToolMemory final : public ShapedMemory
{
public:
  using ShapedMemory::ShapedMemory;

  std::vector<MemoryRange> GetTables() const override
  {
    std::vector<MemoryRange> tables = this->ShapedMemory::GetTables();
    tables.front() = { this, sizeof(*this) };
    this->Carver.AppendTables(tables);
    return tables;
  }

  SphereCarver Carver;
};

} // namespace

BakedBurr::BakedBurr(BurrDescription description)
  : ShapedTool(std::move(description.Head))
  , Settings(description.Settings)
  , SpecificEnergyLine(std::move(description.SpecificEnergy))
  , SpecificEnergy({ this->SpecificEnergyLine, ConstantPolyline(0.0) })
  , RimSpeed(FullTurn * this->Settings.Radius * this->Settings.Speed)
  , Frequency(ComputeFrequency(this->Settings.Speed))
{
}

const ToolColumns& BakedBurr::Columns()
{
  // Never destroyed, because a filter may exist until the process ends.
  static const auto* const columns = new ToolColumns{ { "RemovedVolume", " (mm^3)", 1, true,
    [](const HapticModel&, const TickRecord& record, double* numbers)
    { numbers[0] = record.RemovedVolume; } } };
  return *columns;
}

bool BakedBurr::IsSame(const BakedTool& other) const
{
  const auto* const burr = dynamic_cast<const BakedBurr*>(&other);
  if (!burr || !this->ShapedTool::IsSame(other))
  {
    return false;
  }
  const BurrSettings& a = this->Settings;
  const BurrSettings& b = burr->Settings;
  return a.Radius == b.Radius && a.Speed == b.Speed && a.Friction == b.Friction &&
    a.Vibration == b.Vibration && a.SpinButton == b.SpinButton &&
    IsSameLine(this->SpecificEnergyLine, burr->SpecificEnergyLine);
}

bool BakedBurr::Step(const ToolTick& tick) const noexcept
{
  if (!tick.Memory)
  {
    tick.FeelPoint();
    return false;
  }
  auto& memory = static_cast<BurrToolMemory&>(*tick.Memory);
  ServoState& state = tick.State;
  BurrRecord felt;
  TickBurr(tick.Model, { tick.Record.Tip, state.IsSpinning, tick.Model.Baked->Settings.TickPeriod },
    state.Shell, state.Burr, { memory.Shell, memory.Carver }, felt);
  WriteRecord(tick, felt.Shell);
  tick.Record.Force = felt.Force;
  tick.Record.RemovedVolume = felt.RemovedVolume;
  tick.Record.IsUnfinished = felt.Shell.IsUnfinished || felt.IsUnfinished;
  return false;
}

bool BakedBurr::Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
  ToolMemory* memory) const noexcept
{
  state.Burr = BurrState{};
  return this->ShapedTool::Carry(from, to, state, memory);
}

std::shared_ptr<ToolMemory> BakedBurr::MakeMemory(const std::shared_ptr<ToolMemory>& last) const
{
  const auto* const burr = dynamic_cast<const BurrToolMemory*>(last.get());
  return burr && burr->Points == this->Description.Points
    ? last
    : std::make_shared<BurrToolMemory>(this->Description.Points);
}

void BakedBurr::AppendTables(std::vector<MemoryRange>& tables) const
{
  this->ShapedTool::AppendTables(tables);
  tables.push_back({ &this->Settings, sizeof(*this) - sizeof(ShapedTool) });
  tables.push_back({ this->SpecificEnergy.GetMemory(),
    this->SpecificEnergy.GetMemorySize() - sizeof(this->SpecificEnergy) });
}

bool BakedBurr::Spins(std::uint32_t buttons, bool isOrdered) const noexcept
{
  const int button = this->Settings.SpinButton;
  return isOrdered || (button >= 0 && (buttons >> button & 1U) != 0);
}

std::vector<ShellPoint> BakedBurr::MakeHead(double radius, std::size_t count)
{
  // Place the points along a spiral. Consecutive points differ by the golden angle.
  std::vector<ShellPoint> points;
  points.reserve(count);
  const auto number = static_cast<double>(count);
  const double area = 2.0 * FullTurn * radius * radius / number;
  const double golden = 0.5 * FullTurn * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto n = static_cast<double>(i);
    const double z = 1.0 - (2.0 * n + 1.0) / number;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back(
      { radius * Vector3{ r * std::cos(golden * n), r * std::sin(golden * n), z }, area });
  }
  return points;
}

} // namespace VolumeHaptics
