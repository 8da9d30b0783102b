// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <utility>

namespace VolumeHaptics
{

/** Reads the items of a HID report descriptor in order. Used only by HidReportDescriptor. */
class HidItemReader
{
public:
  explicit HidItemReader(HidReportDescriptor& result)
    : Result(result)
  {
  }

  bool Read(const std::uint8_t* bytes, std::size_t size);

  /**
   * Returns the byte index of the faulty item, or the size of the descriptor if it is incomplete.
   */
  std::size_t GetPosition() const { return this->Position; }
  const std::string& GetError() const { return this->Error; }

private:
  /** The data of an item. Other items determine whether the data are signed. */
  struct Item
  {
    unsigned Tag = 0;
    unsigned Size = 0; ///< number of bytes: 0, 1, 2 or 4
    std::uint32_t Data = 0;

    std::int64_t Signed() const;
  };
  /** Global state, valid until it is changed. Items can push it to a stack. */
  struct GlobalState
  {
    std::uint16_t Page = 0;
    std::uint8_t ReportId = 0;
    std::uint32_t ReportSize = 0;
    std::uint32_t ReportCount = 0;
    std::uint32_t Unit = 0;
    int UnitExponent = 0;
    Item LogicalMinimum, LogicalMaximum, PhysicalMinimum, PhysicalMaximum;
  };
  /** Local state, valid for the next main item. */
  struct LocalState
  {
    struct Usages
    {
      std::uint32_t First = 0;
      std::uint32_t Last = 0;
      bool HasPage = false;
    };
    std::vector<Usages> List;
    std::uint32_t Minimum = 0;
    unsigned MinimumSize = 0; ///< 0 if there is no such item
    bool InAlternatives = false;
    bool HasAlternative = false;
  };

  bool Main(const Item& item);
  bool Global(const Item& item);
  bool Local(const Item& item);
  bool ReportIdItem(const Item& item);
  bool StateStack(const Item& item);
  bool Collection(const Item& item);
  bool Fields(HidReportKind kind, const Item& item);
  void ListFields(HidField field, std::uint32_t count);
  bool AddUsages(std::uint32_t first, std::uint32_t last, bool hasPage);
  HidUsageRange Complete(const LocalState::Usages& usages) const;
  bool Fail(std::string error);

  HidReportDescriptor& Result;
  GlobalState Globals;
  LocalState Locals;
  std::vector<GlobalState> Pushed;
  int OpenCollection = -1;
  int Depth = 0;
  std::size_t Position = 0;
  std::string Error;
};

// Return the data as a signed number of the item's length, as for a minimum. A maximum is signed
// only if the minimum is negative; otherwise, a byte of 0xFF means 255.
std::int64_t HidItemReader::Item::Signed() const
{
  const std::int64_t span = std::int64_t{ 1 } << 8 * this->Size;
  return this->Size > 0 && this->Data >= span / 2 ? this->Data - span : this->Data;
}

bool HidItemReader::Fail(std::string error)
{
  this->Error = std::move(error);
  return false;
}

bool HidItemReader::Read(const std::uint8_t* bytes, std::size_t size)
{
  if (size > HidReportDescriptor::MaximumSize)
  {
    return this->Fail(
      "it is longer than " + std::to_string(HidReportDescriptor::MaximumSize) + " bytes");
  }
  constexpr unsigned longItem = 0xFE;
  constexpr unsigned sizes[] = { 0, 1, 2, 4 };
  for (std::size_t at = 0; at < size;)
  {
    this->Position = at;
    const unsigned prefix = bytes[at];
    std::size_t length = 1 + sizes[prefix & 3];
    if (prefix == longItem)
    {
      length = at + 1 < size ? 3 + std::size_t{ bytes[at + 1] } : 3;
    }
    if (length > size - at)
    {
      return this->Fail("the item is cut short: " + std::to_string(length) + " bytes announced, " +
        std::to_string(size - at) + " left");
    }
    Item item{ prefix >> 4, sizes[prefix & 3], 0 };
    for (unsigned b = 0; prefix != longItem && b < item.Size; ++b)
    {
      item.Data |= std::uint32_t{ bytes[at + 1 + b] } << 8 * b;
    }
    const unsigned type = prefix >> 2 & 3;
    if ((type == 0 && !this->Main(item)) || (type == 1 && !this->Global(item)) ||
      (type == 2 && !this->Local(item)))
    {
      return false;
    }
    at += length;
  }
  this->Position = size;
  return this->Depth == 0 || this->Fail("a Collection has no End Collection");
}

bool HidItemReader::Main(const Item& item)
{
  if (this->Locals.InAlternatives)
  {
    return this->Fail("a main item between delimiters");
  }
  bool holds = true;
  switch (item.Tag)
  {
    case 0x8:
      holds = this->Fields(HidReportKind::Input, item);
      break;
    case 0x9:
      holds = this->Fields(HidReportKind::Output, item);
      break;
    case 0xB:
      holds = this->Fields(HidReportKind::Feature, item);
      break;
    case 0xA:
      holds = this->Collection(item);
      break;
    case 0xC:
      if (this->OpenCollection < 0)
      {
        return this->Fail("End Collection without a Collection");
      }
      this->OpenCollection = this->Result.Collections[this->OpenCollection].Parent;
      --this->Depth;
      break;
    default:
      break;
  }
  this->Locals = LocalState();
  return holds;
}

bool HidItemReader::Collection(const Item& item)
{
  if (this->Depth >= HidReportDescriptor::MaximumDepth)
  {
    return this->Fail("collections are nested more than " +
      std::to_string(HidReportDescriptor::MaximumDepth) + " deep");
  }
  ++this->Depth;
  HidCollection collection;
  collection.Type = static_cast<std::uint8_t>(item.Data);
  collection.Parent = this->OpenCollection;
  collection.Usage =
    this->Locals.List.empty() ? 0 : this->Complete(this->Locals.List.front()).First;
  this->OpenCollection = static_cast<int>(this->Result.Collections.size());
  this->Result.Collections.push_back(collection);
  return true;
}

bool HidItemReader::Fields(HidReportKind kind, const Item& item)
{
  constexpr std::uint32_t constant = 1;
  constexpr std::uint32_t variable = 2;
  constexpr std::uint32_t relative = 4;
  const GlobalState& g = this->Globals;
  if (g.ReportCount == 0)
  {
    return true;
  }
  if (this->Result.HasIds && g.ReportId == 0)
  {
    return this->Fail("a report without an id where others have one");
  }
  if (g.ReportSize < 1 || g.ReportSize > HidReportDescriptor::MaximumBits)
  {
    return this->Fail("fields with a report size of " + std::to_string(g.ReportSize) +
      " bits; 1 to " + std::to_string(HidReportDescriptor::MaximumBits) + " are possible");
  }
  std::uint32_t& bits = this->Result.ReportBits[{ kind, g.ReportId }];
  const std::uint64_t end = bits + std::uint64_t{ g.ReportCount } * g.ReportSize;
  if (end > std::uint64_t{ HidReportDescriptor::MaximumReportSize } * 8)
  {
    return this->Fail("a report count of " + std::to_string(g.ReportCount) +
      " makes the report longer than " + std::to_string(HidReportDescriptor::MaximumReportSize) +
      " bytes");
  }
  const std::uint32_t start = bits;
  bits = static_cast<std::uint32_t>(end);
  // Treat data without a usage as padding, too, because their meaning is unknown, and fields with
  // more than 32 bits, such as OpenFFBoard's 64-bit vendor fields.
  if ((item.Data & constant) != 0 || this->Locals.List.empty() || g.ReportSize > 32)
  {
    return true;
  }
  HidField field;
  field.Kind = kind;
  field.ReportId = g.ReportId;
  field.BitOffset = start;
  field.BitSize = static_cast<std::uint8_t>(g.ReportSize);
  field.IsArray = (item.Data & variable) == 0;
  field.IsRelative = (item.Data & relative) != 0;
  field.LogicalMinimum = g.LogicalMinimum.Signed();
  field.IsSigned = field.LogicalMinimum < 0;
  field.LogicalMaximum = field.IsSigned ? g.LogicalMaximum.Signed() : g.LogicalMaximum.Data;
  field.PhysicalMinimum = g.PhysicalMinimum.Signed();
  field.PhysicalMaximum =
    field.PhysicalMinimum < 0 ? g.PhysicalMaximum.Signed() : g.PhysicalMaximum.Data;
  field.Unit = g.Unit;
  field.UnitExponent = g.UnitExponent;
  field.Collection = this->OpenCollection;
  if (field.LogicalMinimum > field.LogicalMaximum)
  {
    return this->Fail("the logical minimum " + std::to_string(field.LogicalMinimum) +
      " is above the maximum " + std::to_string(field.LogicalMaximum));
  }
  if (this->Result.Fields.size() + g.ReportCount > HidReportDescriptor::MaximumFields)
  {
    return this->Fail("a report count of " + std::to_string(g.ReportCount) + " makes more than " +
      std::to_string(HidReportDescriptor::MaximumFields) + " fields");
  }
  this->ListFields(field, g.ReportCount);
  return true;
}

void HidItemReader::ListFields(HidField field, std::uint32_t count)
{
  if (field.IsArray)
  {
    field.FirstChoice = static_cast<std::uint32_t>(this->Result.Choices.size());
    field.ChoiceRanges = static_cast<std::uint32_t>(this->Locals.List.size());
    for (const LocalState::Usages& usages : this->Locals.List)
    {
      this->Result.Choices.push_back(this->Complete(usages));
    }
  }
  std::size_t list = 0;
  HidUsageRange range = this->Complete(this->Locals.List[0]);
  field.Usage = range.First;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    this->Result.Fields.push_back(field);
    field.BitOffset += field.BitSize;
    if (field.IsArray)
    {
      continue;
    }
    // Each variable has the next usage in the list; variables after the end of the list share the
    // last usage.
    if (field.Usage < range.Last)
    {
      ++field.Usage;
    }
    else if (list + 1 < this->Locals.List.size())
    {
      range = this->Complete(this->Locals.List[++list]);
      field.Usage = range.First;
    }
  }
}

// Returns a range of usages with its page: its own page or, if it has none, the last page before
// the main item, even if that page follows the usage.
HidUsageRange HidItemReader::Complete(const LocalState::Usages& usages) const
{
  const HidUsage page = usages.HasPage ? 0 : MakeHidUsage(this->Globals.Page, 0);
  return { page | usages.First, page | usages.Last };
}

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
      // The exponent has four bits in two's complement. Some devices extend its sign over the whole
      // byte.
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
      // If only one of both usages has a page, the page applies to both.
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

bool HidReportDescriptor::ReadChoice(
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
