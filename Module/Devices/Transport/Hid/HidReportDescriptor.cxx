// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include "Devices/Transport/Hid/HidItemReader.h"

namespace VolumeHaptics
{

bool HidReportDescriptor::Parse(const std::uint8_t* bytes, std::size_t size, std::string& error)
{
  *this = HidReportDescriptor();
  HidItemReader reader(*this);
  if (!reader.Read(bytes, size))
  {
    error = "HID report descriptor, byte " + std::to_string(reader.GetPosition()) + ": " +
      reader.GetError();
    *this = HidReportDescriptor();
    return false;
  }
  return true;
}

std::size_t HidReportDescriptor::GetReportSize(HidReportKind kind, std::uint8_t id) const
{
  const auto found = this->ReportBits.find({ kind, id });
  return found == this->ReportBits.end() ? 0 : (found->second + 7) / 8;
}

bool HidReportDescriptor::IsWithin(const HidField& field, HidUsage usage) const noexcept
{
  for (int c = field.Collection; c >= 0; c = this->Collections[c].Parent)
  {
    if (this->Collections[c].Usage == usage)
    {
      return true;
    }
  }
  return false;
}

bool HidReportDescriptor::FindChoice(
  const HidField& field, HidUsage usage, std::int64_t& value) const noexcept
{
  std::int64_t before = 0;
  for (std::uint32_t c = 0; c < field.ChoiceRanges; ++c)
  {
    const HidUsageRange& range = this->Choices[field.FirstChoice + c];
    if (usage >= range.First && usage <= range.Last)
    {
      value = field.LogicalMinimum + before + (usage - range.First);
      return value <= field.LogicalMaximum;
    }
    before += std::int64_t{ range.Last } - range.First + 1;
  }
  return false;
}

} // namespace VolumeHaptics
