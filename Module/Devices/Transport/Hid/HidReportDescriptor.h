// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reports of a HID device as the device describes them, after the HID 1.11 specification,
 * 6.2.2.
 *
 * Long items and reserved ones are skipped. Constant fields (padding) and fields of more than 32
 * bits take up their bits and are not listed. The first of several alternatives between delimiters
 * counts. Any bytes are accepted, because a device can be broken or hostile. Parsing allocates,
 * within limits, and belongs outside the servo loop; the functions that read and write fields are
 * in HidField.h.
 */
#ifndef HidReportDescriptor_h
#define HidReportDescriptor_h

#include "Devices/Transport/Hid/HidField.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

struct HidCollection
{
  HidUsage Usage = 0;    ///< 0 if the collection has no usage
  std::uint8_t Type = 0; ///< 0 for physical, 1 for application, 2 for logical, and so on
  int Parent = -1;       ///< index in the list of collections; -1 if there is none
};

/** Consecutive usages on a page. */
struct HidUsageRange
{
  HidUsage First = 0;
  HidUsage Last = 0;
};

class HidReportDescriptor
{
public:
  ///@{
  /** Limits of an accepted descriptor. Real devices stay far below. */
  static constexpr std::size_t MaximumSize = 16384; ///< bytes of a descriptor
  static constexpr int MaximumDepth = 32; ///< nesting of collections, and of pushed states
  static constexpr std::size_t MaximumFields = 4096;
  static constexpr std::size_t MaximumUsages = 1024; ///< number of usage ranges for one main item
  static constexpr std::uint32_t MaximumBits = 256;  ///< bits of a field, as in Linux
  static constexpr std::uint32_t MaximumReportSize = 4096; ///< bytes of a payload
  ///@}

  /**
   * Parses the descriptor. If it is not valid, returns false, writes the fault and the index of its
   * byte to `error`, and lists nothing.
   */
  bool Parse(const std::uint8_t* bytes, std::size_t size, std::string& error);

  ///@{
  /** Return the data fields and the collections, in the order of the descriptor. */
  const std::vector<HidField>& GetFields() const noexcept { return this->Fields; }
  const std::vector<HidCollection>& GetCollections() const noexcept { return this->Collections; }
  ///@}

  /** Returns whether each report begins with its id. */
  bool UsesReportIds() const noexcept { return this->HasIds; }

  /**
   * Returns the number of bytes of a payload, including padding but not the id. Returns 0 if there
   * is no such report.
   */
  std::size_t GetReportSize(HidReportKind kind, std::uint8_t id) const;

  /** Returns whether one of the collections around a field has a usage. */
  bool IsWithin(const HidField& field, HidUsage usage) const noexcept;

  /**
   * Writes the value of an array field that selects a usage to `value`. Returns false if the field
   * is not an array or does not list the usage.
   */
  bool ReadChoice(const HidField& field, HidUsage usage, std::int64_t& value) const noexcept;

private:
  friend class HidItemReader;

  std::vector<HidField> Fields;
  std::vector<HidCollection> Collections;
  std::vector<HidUsageRange> Choices;
  std::map<std::pair<HidReportKind, std::uint8_t>, std::uint32_t> ReportBits;
  bool HasIds = false;
};

} // namespace VolumeHaptics

#endif
