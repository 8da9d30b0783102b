// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses a HID device's own description of its reports, according to the HID 1.11 specification,
 * 6.2.2.
 *
 * Long and reserved items are skipped. Constant fields (padding) and fields of more than 32 bits
 * occupy their bits but are not listed. Of several alternatives between delimiters, the first one
 * is used. Any input is safe, because a device can be broken or hostile. Parsing allocates a
 * limited amount of memory, and must not be called in the servo loop; the functions that read and
 * write fields are in HidField.h.
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
  int Parent = -1;       ///< index in the list of collections; -1 if none
};

/** A range of consecutive usages on a page. */
struct HidUsageRange
{
  HidUsage First = 0;
  HidUsage Last = 0;
};

class HidReportDescriptor
{
public:
  ///@{
  /** Limits of an accepted descriptor, far above those of real devices. */
  static constexpr std::size_t MaximumSize = 16384; ///< bytes of a descriptor
  static constexpr int MaximumDepth = 32; ///< nesting of collections, and of pushed states
  static constexpr std::size_t MaximumFields = 4096;
  static constexpr std::size_t MaximumUsages = 1024; ///< number of usage ranges for one main item
  static constexpr std::uint32_t MaximumBits = 256;  ///< bits of a field, as in Linux
  static constexpr std::uint32_t MaximumReportSize = 4096; ///< bytes of a payload
  ///@}

  /**
   * Parses the descriptor. If it is not valid, returns false, writes the fault and its byte index
   * to `error`, and clears the lists.
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
   * Returns the number of bytes of a payload, including padding but not the id; 0 if there is no
   * such report.
   */
  std::size_t GetReportSize(HidReportKind kind, std::uint8_t id) const;

  /** Returns whether one of the collections that contain a field has this usage. */
  bool IsWithin(const HidField& field, HidUsage usage) const noexcept;

  /**
   * Writes the value with which an array field selects a usage to `value`. Returns false if the
   * field is not an array or does not list the usage.
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
