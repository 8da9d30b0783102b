// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One value in a HID report: where its bits are, and what they mean.
 *
 * Reports are handled as payloads: the bytes after the report id, whether the device uses ids or
 * not. Bits are counted from the lowest of the first byte on, as in the HID 1.11 specification, 8.
 * Everything here is fit for the servo loop: no allocation, no exception, and no byte outside the
 * size that is given is touched.
 */
#ifndef HidField_h
#define HidField_h

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/** A usage with its page: the page in the upper 16 bits. */
using HidUsage = std::uint32_t;
constexpr HidUsage MakeHidUsage(std::uint16_t page, std::uint16_t usage) noexcept
{
  return HidUsage{ page } << 16 | usage;
}

enum class HidReportKind : std::uint8_t
{
  Input,
  Output,
  Feature
};

struct HidField
{
  HidReportKind Kind = HidReportKind::Input;
  std::uint8_t ReportId = 0; ///< 0 where the device uses no ids
  std::uint8_t BitSize = 0;  ///< 1 to 32
  /// The value does not count something but chooses one of the usages that the descriptor lists.
  bool IsArray = false;
  bool IsRelative = false;
  /// Two's complement, which is so where the logical minimum is below zero.
  bool IsSigned = false;
  std::uint32_t BitOffset = 0; ///< in the payload
  HidUsage Usage = 0;          ///< of an array, the first
  int Collection = -1;         ///< the innermost one, in the descriptor's list; -1: none

  ///@{
  /** The range on the wire and the physical range; both physical limits 0: the same range. */
  std::int64_t LogicalMinimum = 0;
  std::int64_t LogicalMaximum = 0;
  std::int64_t PhysicalMinimum = 0;
  std::int64_t PhysicalMaximum = 0;
  ///@}
  std::uint32_t Unit = 0;         ///< as HID 1.11, 6.2.2.7 packs it; 0: none
  int UnitExponent = 0;           ///< the physical value times ten to the power of this is in Unit
  std::uint32_t FirstChoice = 0;  ///< of an array: where its usages begin in the descriptor's list
  std::uint32_t ChoiceRanges = 0; ///< of an array: how many ranges of usages it has
};

/** The nearest value within the logical range and within what the bits hold: no sign ever wraps. */
std::int64_t ClampToField(const HidField& field, std::int64_t value) noexcept;

/** The bits as they are, with their sign; false, and 0, where the payload is too short. */
bool ReadRaw(const HidField& field, const std::uint8_t* payload, std::size_t size,
  std::int64_t& value) noexcept;

/**
 * As ReadRaw, but false for what is outside the logical range, too: that is HID's null value, which
 * says that there is none.
 */
bool ReadValue(const HidField& field, const std::uint8_t* payload, std::size_t size,
  std::int64_t& value) noexcept;

/**
 * Puts the clamped value where it belongs and leaves all other bits; false, with nothing written,
 * where the payload is too short.
 */
bool WriteValue(
  const HidField& field, std::uint8_t* payload, std::size_t size, std::int64_t value) noexcept;

} // namespace VolumeHaptics

#endif
