// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidProtocol.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{
/** A duration (s) as the field's logical value, in its own unit and scale. */
std::int64_t ToLogical(const HidField& field, double quantity, double unitWithoutUnit) noexcept
{
  const double unit = field.Unit == 0 ? unitWithoutUnit : std::pow(10.0, field.UnitExponent);
  double value = quantity / unit;
  if (field.PhysicalMinimum < field.PhysicalMaximum)
  {
    const auto physical = static_cast<double>(field.PhysicalMaximum - field.PhysicalMinimum);
    const auto logical = static_cast<double>(field.LogicalMaximum - field.LogicalMinimum);
    value = static_cast<double>(field.LogicalMinimum) +
      (value - static_cast<double>(field.PhysicalMinimum)) * logical / physical;
  }
  constexpr double most = 4294967295.0;
  return std::llround(std::max(0.0, std::min(value, most)));
}
} // namespace

HidReport PidDevice::Begin(const Shape& shape) noexcept
{
  HidReport report;
  report.Kind = shape.Kind;
  report.Size = shape.Size;
  report.Bytes[0] = shape.Id;
  return report;
}

void PidDevice::Put(HidReport& report, const Slot& slot, std::int64_t value) noexcept
{
  if (slot.Known)
  {
    WriteValue(slot.Field, report.Payload(), report.Size, value);
  }
}

void PidDevice::Choose(HidReport& report, const Slot& slot) noexcept
{
  PidDevice::Put(report, slot, slot.Value);
}

bool PidDevice::IsChosen(const Slot& slot, const std::uint8_t* payload, std::size_t size) noexcept
{
  std::int64_t value = 0;
  return slot.Known && ReadValue(slot.Field, payload, size, value) && value == slot.Value;
}

HidReport PidDevice::Control(PidUsage command) const noexcept
{
  HidReport report = PidDevice::Begin(this->ControlShape);
  if (command == PidUsage::EnableActuators)
  {
    PidDevice::Choose(report, this->Enable);
  }
  else if (command == PidUsage::StopAllEffects)
  {
    PidDevice::Choose(report, this->StopAll);
  }
  else if (command == PidUsage::DeviceReset)
  {
    PidDevice::Choose(report, this->Reset);
  }
  return report;
}

HidReport PidDevice::FullGain() const noexcept
{
  HidReport report = PidDevice::Begin(this->Gain);
  PidDevice::Put(report, this->DeviceGain, this->DeviceGain.Field.LogicalMaximum);
  return report;
}

HidReport PidDevice::CreateConstant() const noexcept
{
  HidReport report = PidDevice::Begin(this->Create);
  PidDevice::Choose(report, this->CreateType);
  return report;
}

// What is not written here stays 0: no trigger button, no delay, no sample period of its own.
HidReport PidDevice::SetEffect(std::int64_t block, int axis, double duration) const noexcept
{
  HidReport report = PidDevice::Begin(this->Effect);
  PidDevice::Put(report, this->EffectBlock, block);
  PidDevice::Choose(report, this->EffectType);
  PidDevice::Put(report, this->Duration,
    std::max<std::int64_t>(1, ToLogical(this->Duration.Field, duration, 1e-3)));
  PidDevice::Put(report, this->EffectGain, this->EffectGain.Field.LogicalMaximum);
  // By the direction wherever there is one, as Linux does. Where the axes' bits are set instead,
  // the firmwares disagree about what the direction means then.
  if (this->DirectionEnable.Known)
  {
    PidDevice::Put(report, this->DirectionEnable, 1);
  }
  else
  {
    PidDevice::Put(report, this->AxisEnable[axis], 1);
  }
  // Polar, clockwise from the north; the field's range is the whole circle, whatever its unit, as
  // for Linux.
  const double circle = axis == 0 ? 0.25 : 0.5;
  const HidField& field = this->Direction.Field;
  PidDevice::Put(report, this->Direction,
    field.LogicalMinimum +
      std::llround(circle * static_cast<double>(field.LogicalMaximum - field.LogicalMinimum)));
  return report;
}

HidReport PidDevice::Operate(std::int64_t block, PidUsage operation) const noexcept
{
  HidReport report = PidDevice::Begin(this->Operation);
  PidDevice::Put(report, this->OperationBlock, block);
  PidDevice::Choose(report, operation == PidUsage::EffectStart ? this->Start : this->Stop);
  PidDevice::Put(report, this->Loops, 1);
  return report;
}

HidReport PidDevice::SetConstant(
  std::int64_t block, double newtons, double newtonsPerFullScale) const noexcept
{
  HidReport report = PidDevice::Begin(this->Constant);
  PidDevice::Put(report, this->ConstantBlock, block);
  // The same scale both ways, also where the range has one value more below zero.
  const HidField& field = this->Magnitude.Field;
  const auto fullScale = static_cast<double>(std::min(
    -ClampToField(field, field.LogicalMinimum), ClampToField(field, field.LogicalMaximum)));
  const double part = newtons / newtonsPerFullScale;
  const bool isSafe =
    std::isfinite(newtons) && std::isfinite(newtonsPerFullScale) && newtonsPerFullScale != 0.0;
  PidDevice::Put(report, this->Magnitude,
    isSafe ? std::llround(std::max(-1.0, std::min(part, 1.0)) * fullScale) : 0);
  return report;
}

HidReport PidDevice::AskPool() const noexcept
{
  return PidDevice::Begin(this->Pool);
}

HidReport PidDevice::AskBlockLoad() const noexcept
{
  return PidDevice::Begin(this->Load);
}

int PidDevice::ReadPool(const std::uint8_t* payload, std::size_t size) const noexcept
{
  std::int64_t effects = 0;
  const bool came =
    this->Simultaneous.Known && ReadValue(this->Simultaneous.Field, payload, size, effects);
  return came ? static_cast<int>(std::max<std::int64_t>(0, std::min<std::int64_t>(effects, 1000)))
              : 0;
}

BlockLoadStatus PidDevice::ReadBlockLoad(
  const std::uint8_t* payload, std::size_t size, std::int64_t& block) const noexcept
{
  block = 0;
  if (PidDevice::IsChosen(this->Full, payload, size))
  {
    return BlockLoadStatus::Full;
  }
  if (PidDevice::IsChosen(this->LoadError, payload, size))
  {
    return BlockLoadStatus::Error;
  }
  const bool done = PidDevice::IsChosen(this->Success, payload, size) &&
    ReadValue(this->LoadBlock.Field, payload, size, block) && block > 0;
  return done ? BlockLoadStatus::Success : BlockLoadStatus::Waiting;
}

} // namespace VolumeHaptics
