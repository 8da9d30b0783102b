// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidMapper.h"

namespace VolumeHaptics
{

bool PidMapper::Turn(PidUsage report, HidReportKind kind, const char* name, PidDevice::Shape& shape)
{
  shape = PidDevice::Shape();
  this->Report = report;
  this->Name = name;
  this->Current = &shape;
  for (const HidField& field : this->Descriptor.GetFields())
  {
    if (field.Kind == kind && this->Descriptor.IsWithin(field, Of(report)))
    {
      shape = { true, kind, field.ReportId, this->Descriptor.GetReportSize(kind, field.ReportId) };
      break;
    }
  }
  if (shape.Size > HidReport::Capacity)
  {
    this->RecordMissing("a report of at most 64 bytes: " + std::string(name));
    shape.Known = false;
  }
  return shape.Known;
}

bool PidMapper::Find(HidUsage usage, PidDevice::Slot& slot, HidUsage within) const
{
  slot = PidDevice::Slot();
  for (const HidField& field : this->Descriptor.GetFields())
  {
    std::int64_t value = field.LogicalMaximum;
    const bool matches =
      field.IsArray ? this->Descriptor.ReadChoice(field, usage, value) : field.Usage == usage;
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

void PidMapper::Need(PidUsage usage, const char* name, PidDevice::Slot& slot)
{
  if (this->Current->Known && !this->Find(usage, slot))
  {
    this->RecordMissing(std::string(name) + " in " + this->Name);
  }
}

void PidMapper::RecordMissing(const std::string& what)
{
  this->Missing += (this->Missing.empty() ? "" : ", ") + what;
}

} // namespace VolumeHaptics
