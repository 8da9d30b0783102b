// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidItemReader.h"

namespace VolumeHaptics
{

bool HidItemReader::Global(const Item& item)
{
  GlobalState& g = this->Globals;
  switch (item.Tag)
  {
    case 0x0:
      g.Page = static_cast<std::uint16_t>(item.Data);
      return true;
    case 0x1:
      g.LogicalMinimum = item;
      return true;
    case 0x2:
      g.LogicalMaximum = item;
      return true;
    case 0x3:
      g.PhysicalMinimum = item;
      return true;
    case 0x4:
      g.PhysicalMaximum = item;
      return true;
    case 0x5:
      // Four bits, two's complement; some devices extend the sign over the byte.
      g.UnitExponent = static_cast<int>(item.Data & 0xF) - ((item.Data & 8) != 0 ? 16 : 0);
      return true;
    case 0x6:
      g.Unit = item.Data;
      return true;
    case 0x7:
      g.ReportSize = item.Data;
      return true;
    case 0x8:
      return this->ReportIdItem(item);
    case 0x9:
      g.ReportCount = item.Data;
      return true;
    default:
      return this->StateStack(item);
  }
}

bool HidItemReader::ReportIdItem(const Item& item)
{
  if (item.Data < 1 || item.Data > 255)
  {
    return this->Fail("a report id of " + std::to_string(item.Data) + "; 1 to 255 are possible");
  }
  if (!this->Result.HasIds && !this->Result.ReportBits.empty())
  {
    return this->Fail("a report id after reports that have none");
  }
  this->Result.HasIds = true;
  this->Globals.ReportId = static_cast<std::uint8_t>(item.Data);
  return true;
}

bool HidItemReader::StateStack(const Item& item)
{
  constexpr unsigned push = 0xA;
  constexpr unsigned pop = 0xB;
  if (item.Tag == push)
  {
    if (this->Pushed.size() >= HidReportDescriptor::MaximumDepth)
    {
      return this->Fail(
        "Push more than " + std::to_string(HidReportDescriptor::MaximumDepth) + " deep");
    }
    this->Pushed.push_back(this->Globals);
  }
  else if (item.Tag == pop)
  {
    if (this->Pushed.empty())
    {
      return this->Fail("Pop without a Push");
    }
    this->Globals = this->Pushed.back();
    this->Pushed.pop_back();
  }
  return true;
}

bool HidItemReader::Local(const Item& item)
{
  LocalState& l = this->Locals;
  switch (item.Tag)
  {
    case 0x0:
      return this->AddUsages(item.Data, item.Data, item.Size == 4);
    case 0x1:
      l.Minimum = item.Data;
      l.MinimumSize = item.Size + 1;
      return true;
    case 0x2:
    {
      // With a page in one and none in the other, the page is that of the one that has it.
      const bool hasPage = item.Size == 4 || l.MinimumSize == 5;
      const std::uint32_t page = (item.Size == 4 ? item.Data : l.Minimum) & 0xFFFF0000U;
      const std::uint32_t first = (l.Minimum & 0xFFFFU) | (hasPage ? page : 0);
      const std::uint32_t last = (item.Data & 0xFFFFU) | (hasPage ? page : 0);
      if (l.MinimumSize == 0 || first > last)
      {
        return this->Fail("a usage maximum without a usage minimum below it");
      }
      l.MinimumSize = 0;
      return this->AddUsages(first, last, hasPage);
    }
    case 0xA:
      if (l.InAlternatives == (item.Data != 0))
      {
        return this->Fail("delimiters that do not pair up");
      }
      l.InAlternatives = item.Data != 0;
      l.HasAlternative = false;
      return true;
    default:
      return true;
  }
}

bool HidItemReader::AddUsages(std::uint32_t first, std::uint32_t last, bool hasPage)
{
  if (this->Locals.InAlternatives && this->Locals.HasAlternative)
  {
    return true;
  }
  if (this->Locals.List.size() >= HidReportDescriptor::MaximumUsages)
  {
    return this->Fail("more than " + std::to_string(HidReportDescriptor::MaximumUsages) +
      " usages for one main item");
  }
  this->Locals.HasAlternative = true;
  this->Locals.List.push_back({ first, last, hasPage });
  return true;
}

} // namespace VolumeHaptics
