// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidDevice.h"

#include "Devices/Pid/PidMapper.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr std::uint16_t OrdinalPage = 0x0A;
constexpr HidUsage AxisUsages[] = { MakeHidUsage(0x01, 0x30), MakeHidUsage(0x01, 0x31) };

/**
 * Converts a quantity, such as a duration (s), to a field's logical value, in the field's unit and
 * range.
 */
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

bool PidDevice::Map(const HidReportDescriptor& descriptor, std::string& error)
{
  *this = PidDevice();
  PidMapper mapper(descriptor);
  const auto need = [&mapper](PidUsage report, HidReportKind kind, const char* name, Shape& shape)
  {
    if (!mapper.Turn(report, kind, name, shape))
    {
      mapper.RecordMissing(name);
    }
  };
  constexpr HidReportKind output = HidReportKind::Output;
  constexpr HidReportKind feature = HidReportKind::Feature;

  // The usage of the control may be outside a collection with the report's usage.
  if (!mapper.Turn(PidUsage::DeviceControlReport, output, "Device Control", this->ControlShape))
  {
    need(PidUsage::DeviceControl, output, "Device Control", this->ControlShape);
  }
  mapper.Need(PidUsage::EnableActuators, "Enable Actuators", this->Enable);
  mapper.Need(PidUsage::StopAllEffects, "Stop All Effects", this->StopAll);
  mapper.Need(PidUsage::DeviceReset, "Device Reset", this->Reset);

  if (!mapper.Turn(PidUsage::CreateNewEffectReport, feature, "Create New Effect", this->Create))
  {
    need(PidUsage::CreateNewEffect, feature, "Create New Effect", this->Create);
  }
  mapper.Need(PidUsage::ConstantForce, "Constant Force", this->CreateType);

  need(PidUsage::BlockLoadReport, feature, "Block Load", this->Load);
  mapper.Need(PidUsage::EffectBlockIndex, "Effect Block Index", this->LoadBlock);
  mapper.Need(PidUsage::BlockLoadSuccess, "Block Load Success", this->Success);
  mapper.Find(PidUsage::BlockLoadFull, this->Full);
  mapper.Find(PidUsage::BlockLoadError, this->LoadError);

  need(PidUsage::SetEffectReport, output, "Set Effect", this->Effect);
  mapper.Need(PidUsage::EffectBlockIndex, "Effect Block Index", this->EffectBlock);
  mapper.Need(PidUsage::ConstantForce, "Constant Force", this->EffectType);
  mapper.Need(PidUsage::Duration, "Duration", this->Duration);
  mapper.Find(PidUsage::Gain, this->EffectGain);
  mapper.Find(PidUsage::DirectionEnable, this->DirectionEnable);
  for (int axis = 0; axis < 2; ++axis)
  {
    mapper.Find(AxisUsages[axis], this->AxisEnable[axis], PidMapper::Of(PidUsage::AxesEnable));
  }
  // There is either one angle, or several angles with ordinal numbers.
  const bool isNumbered =
    mapper.Find(MakeHidUsage(OrdinalPage, 1), this->Direction, PidMapper::Of(PidUsage::Direction));
  if (!isNumbered)
  {
    mapper.Find(PidUsage::Direction, this->Direction);
  }
  const bool hasPolar = this->Direction.Known && this->DirectionEnable.Known;
  this->Axes = this->AxisEnable[1].Known || (!this->AxisEnable[0].Known && hasPolar) ? 2 : 1;

  need(PidUsage::SetConstantForceReport, output, "Set Constant Force", this->Constant);
  mapper.Need(PidUsage::EffectBlockIndex, "Effect Block Index", this->ConstantBlock);
  mapper.Need(PidUsage::Magnitude, "Magnitude", this->Magnitude);
  const HidField& magnitude = this->Magnitude.Field;
  this->IsSigned = !this->Magnitude.Known || magnitude.LogicalMinimum < 0;
  // If the magnitude has no sign, a force is reversed by reversing its direction, as in hid-pidff's
  // pidff_set_signed().
  const bool canReverse = this->IsSigned || (magnitude.LogicalMinimum == 0 && hasPolar);
  if (this->Magnitude.Known && (magnitude.LogicalMaximum <= 0 || !canReverse))
  {
    mapper.RecordMissing("a Magnitude that can be below and above zero, or a direction");
  }

  need(PidUsage::EffectOperationReport, output, "Effect Operation", this->Operation);
  mapper.Need(PidUsage::EffectBlockIndex, "Effect Block Index", this->OperationBlock);
  mapper.Need(PidUsage::EffectStart, "Effect Start", this->Start);
  mapper.Need(PidUsage::EffectStop, "Effect Stop", this->Stop);
  mapper.Find(PidUsage::LoopCount, this->Loops);

  mapper.Turn(PidUsage::PoolReport, feature, "Pool", this->Pool);
  mapper.Find(PidUsage::SimultaneousEffects, this->Simultaneous);
  mapper.Turn(PidUsage::DeviceGainReport, output, "Device Gain", this->Gain);
  mapper.Find(PidUsage::DeviceGain, this->DeviceGain);

  if (!mapper.GetMissing().empty())
  {
    error = "No force feedback with this HID device; missing: " + mapper.GetMissing();
    *this = PidDevice();
    return false;
  }
  return true;
}

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

// Set a bit even where OpenFFBoard's descriptor for one axis states that the only value is 0.
void PidDevice::SwitchOn(HidReport& report, const Slot& slot) noexcept
{
  if (slot.Known)
  {
    WriteRaw(slot.Field, report.Payload(), report.Size, 1);
  }
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

// Sets the effect's fields. All other fields stay 0: no trigger button, no delay, no sample period.
HidReport PidDevice::SetEffect(std::int64_t block, int effect, double duration) const noexcept
{
  const int axis = this->GetAxis(effect);
  HidReport report = PidDevice::Begin(this->Effect);
  PidDevice::Put(report, this->EffectBlock, block);
  PidDevice::Choose(report, this->EffectType);
  PidDevice::Put(report, this->Duration,
    std::max<std::int64_t>(1, ToLogical(this->Duration.Field, duration, 1e-3)));
  PidDevice::Put(report, this->EffectGain, this->EffectGain.Field.LogicalMaximum);
  // Use the direction if available, as Linux does: firmwares interpret the direction differently if
  // the axes' bits are set instead.
  const bool hasDirection = this->DirectionEnable.Known && !this->HasShares;
  PidDevice::SwitchOn(report, hasDirection ? this->DirectionEnable : this->AxisEnable[axis]);
  // The direction is an angle, clockwise from north. As in Linux, the field's range stands for the
  // whole circle, whatever the unit; with HasShares, it stands for the whole axis.
  const double turn = this->IsSigned || effect % 2 == 0 ? 0.0 : 0.5;
  const double circle = this->HasShares ? 1.0 : turn + (axis == 0 ? 0.25 : 0.0);
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
  std::int64_t block, int effect, double newtons, double newtonsPerFullScale) const noexcept
{
  HidReport report = PidDevice::Begin(this->Constant);
  PidDevice::Put(report, this->ConstantBlock, block);
  // Use the same scale for both directions, even if the range has one more value below zero.
  const HidField& field = this->Magnitude.Field;
  const std::int64_t most = ClampToField(field, field.LogicalMaximum);
  const auto fullScale = static_cast<double>(
    this->IsSigned ? std::min(-ClampToField(field, field.LogicalMinimum), most) : most);
  const double least = this->IsSigned ? -1.0 : 0.0;
  const double part =
    (this->IsSigned || effect % 2 == 0 ? newtons : -newtons) / newtonsPerFullScale;
  const bool isSafe =
    std::isfinite(newtons) && std::isfinite(newtonsPerFullScale) && newtonsPerFullScale != 0.0;
  PidDevice::Put(report, this->Magnitude,
    isSafe ? std::llround(std::max(least, std::min(part, 1.0)) * fullScale) : 0);
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
