// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walks the items of a HID report descriptor; used by HidReportDescriptor only.
 */
#ifndef HidItemReader_h
#define HidItemReader_h

#include "Devices/Transport/Hid/HidReportDescriptor.h"

namespace VolumeHaptics
{

class HidItemReader
{
public:
  explicit HidItemReader(HidReportDescriptor& result)
    : Result(result)
  {
  }

  bool Read(const std::uint8_t* bytes, std::size_t size);

  /** The position of the faulty item, or the size if something is missing at the end. */
  std::size_t GetPosition() const { return this->Position; }
  const std::string& GetError() const { return this->Error; }

private:
  /** The data of an item; other items decide whether it is signed. */
  struct Item
  {
    unsigned Tag = 0;
    unsigned Size = 0; ///< bytes: 0, 1, 2 or 4
    std::uint32_t Data = 0;

    std::int64_t Signed() const;
  };
  /** Global state: holds until it is changed, and can be pushed. */
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
  /** Local state: holds for the next main item. */
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
    unsigned MinimumSize = 0; ///< 0: the item was missing
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

} // namespace VolumeHaptics

#endif
