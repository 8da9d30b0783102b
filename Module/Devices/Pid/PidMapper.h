// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the reports and fields of a force-feedback device by their usages.
 */
#ifndef PidMapper_h
#define PidMapper_h

#include "Devices/Pid/PidDevice.h"

namespace VolumeHaptics
{

/**
 * Searches the descriptor of one device for PidDevice::Map, and collects the missing parts.
 *
 * Turn() selects a report; Find() and Need() then search it for fields.
 */
class PidMapper
{
public:
  explicit PidMapper(const HidReportDescriptor& descriptor)
    : Descriptor(descriptor)
  {
  }

  /** Returns a usage of the PID page, including the page. */
  static constexpr HidUsage Of(PidUsage usage) noexcept
  {
    return MakeHidUsage(0x0F, static_cast<std::uint16_t>(usage));
  }

  /** Selects the report with a usage. Returns false if there is no such usable report. */
  bool Turn(PidUsage report, HidReportKind kind, const char* name, PidDevice::Shape& shape);

  ///@{
  /**
   * Finds the field that has a usage: a number, a bit, or a choice of an array. `within` is the
   * usage of a collection around it. Returns false if there is none.
   */
  bool Find(HidUsage usage, PidDevice::Slot& slot, HidUsage within = 0) const;
  bool Find(PidUsage usage, PidDevice::Slot& slot) const { return this->Find(Of(usage), slot); }
  ///@}

  /** Like Find(), but records a missing field. */
  void Need(PidUsage usage, const char* name, PidDevice::Slot& slot);

  void RecordMissing(const std::string& what);
  /** Returns all missing parts, separated by commas. */
  const std::string& GetMissing() const { return this->Missing; }

private:
  const HidReportDescriptor& Descriptor;
  PidUsage Report = PidUsage::SetEffectReport;
  const char* Name = "";
  const PidDevice::Shape* Current = nullptr;
  std::string Missing;
};

} // namespace VolumeHaptics

#endif
