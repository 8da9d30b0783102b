// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidProtocol.h"

namespace VolumeHaptics
{
namespace
{
constexpr std::uint16_t PidPage = 0x0F;
constexpr std::uint16_t OrdinalPage = 0x0A;
constexpr HidUsage AxisUsages[] = { MakeHidUsage(0x01, 0x30), MakeHidUsage(0x01, 0x31) };

constexpr HidUsage Of(PidUsage usage)
{
  return MakeHidUsage(PidPage, static_cast<std::uint16_t>(usage));
}
} // namespace

/** Looks for one device's reports and collects what is missing. */
class PidMapper
{
public:
  explicit PidMapper(const HidReportDescriptor& descriptor)
    : Descriptor(descriptor)
  {
  }

  const std::string& GetMissing() const { return this->Missing; }

  /** Turns to the report with this usage; what is found from now on is in it. */
  bool Turn(PidUsage report, HidReportKind kind, const char* name, PidDevice::Shape& shape)
  {
    shape = PidDevice::Shape();
    this->Report = report;
    this->Name = name;
    this->Current = &shape;
    for (const HidField& field : this->Descriptor.GetFields())
    {
      if (field.Kind == kind && this->Descriptor.IsWithin(field, Of(report)))
      {
        shape = { true, kind, field.ReportId,
          this->Descriptor.GetReportSize(kind, field.ReportId) };
        break;
      }
    }
    if (shape.Size > HidReport::Capacity)
    {
      this->Miss("a report of at most 64 bytes: " + std::string(name));
      shape.Known = false;
    }
    return shape.Known;
  }

  /** A field that holds a number, or a bit or an array's choice that stands for the usage. */
  bool Find(HidUsage usage, PidDevice::Slot& slot, HidUsage within = 0) const
  {
    slot = PidDevice::Slot();
    for (const HidField& field : this->Descriptor.GetFields())
    {
      std::int64_t value = field.LogicalMaximum;
      const bool matches =
        field.IsArray ? this->Descriptor.FindChoice(field, usage, value) : field.Usage == usage;
      if (this->Current->Known && matches && field.Kind == this->Current->Kind &&
        field.ReportId == this->Current->Id && this->Descriptor.IsWithin(field, Of(this->Report)) &&
        (within == 0 || this->Descriptor.IsWithin(field, within)))
      {
        slot = { true, field, value };
        return true;
      }
    }
    return false;
  }
  bool Find(PidUsage usage, PidDevice::Slot& slot) const { return this->Find(Of(usage), slot); }

  void Need(PidUsage usage, const char* name, PidDevice::Slot& slot)
  {
    if (this->Current->Known && !this->Find(usage, slot))
    {
      this->Miss(std::string(name) + " in " + this->Name);
    }
  }
  void Miss(const std::string& what)
  {
    this->Missing += (this->Missing.empty() ? "" : ", ") + what;
  }

private:
  const HidReportDescriptor& Descriptor;
  PidUsage Report = PidUsage::SetEffectReport;
  const char* Name = "";
  const PidDevice::Shape* Current = nullptr;
  std::string Missing;
};

bool PidDevice::Map(const HidReportDescriptor& descriptor, std::string& error)
{
  *this = PidDevice();
  PidMapper mapper(descriptor);
  const auto need = [&mapper](PidUsage report, HidReportKind kind, const char* name, Shape& shape)
  {
    if (!mapper.Turn(report, kind, name, shape))
    {
      mapper.Miss(name);
    }
  };
  constexpr HidReportKind output = HidReportKind::Output;
  constexpr HidReportKind feature = HidReportKind::Feature;

  // The report's usage may be left out around the control's own.
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
    mapper.Find(AxisUsages[axis], this->AxisEnable[axis], Of(PidUsage::AxesEnable));
  }
  // One angle, or one of more that are numbered.
  const bool isNumbered =
    mapper.Find(MakeHidUsage(OrdinalPage, 1), this->Direction, Of(PidUsage::Direction));
  if (!isNumbered)
  {
    mapper.Find(PidUsage::Direction, this->Direction);
  }
  const bool hasPolar = this->Direction.Known && this->DirectionEnable.Known;
  this->Axes = this->AxisEnable[1].Known || (!this->AxisEnable[0].Known && hasPolar) ? 2 : 1;

  need(PidUsage::SetConstantForceReport, output, "Set Constant Force", this->Constant);
  mapper.Need(PidUsage::EffectBlockIndex, "Effect Block Index", this->ConstantBlock);
  mapper.Need(PidUsage::Magnitude, "Magnitude", this->Magnitude);
  if (this->Magnitude.Known &&
    (!this->Magnitude.Field.IsSigned || this->Magnitude.Field.LogicalMaximum <= 0))
  {
    mapper.Miss("a Magnitude that can be below and above zero");
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

} // namespace VolumeHaptics
