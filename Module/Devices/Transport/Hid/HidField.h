// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One value in a HID report: the position of its bits, and their meaning.
 *
 * Reports are handled as payloads: the bytes after the report id, whether or not the device uses
 * ids. Bits are counted from the lowest bit of the first byte, as in section 8 of the HID 1.11
 * specification. All functions are safe in the servo loop: they neither allocate nor throw, and
 * access no memory outside the given size.
 */
#ifndef HidField_h
#define HidField_h

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/** A usage, with its page in the upper 16 bits. */
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
  std::uint8_t ReportId = 0; ///< 0 if the device does not use ids
  std::uint8_t BitSize = 0;  ///< number of bits, 1 to 32
  /// Whether the value is the index of a selected usage from the descriptor's list, instead of a
  /// number.
  bool IsArray = false;
  bool IsRelative = false;
  /// Whether the value is in two's complement, which is the case if the logical minimum is
  /// negative.
  bool IsSigned = false;
  std::uint32_t BitOffset = 0; ///< index of the first bit in the payload
  HidUsage Usage = 0;          ///< usage; for an array, its first usage
  int Collection = -1;         ///< index of the innermost collection in the descriptor; -1 if none

  ///@{
  /**
   * The logical range (of the transmitted value) and the physical range. If both physical limits
   * are 0, both ranges are equal.
   */
  std::int64_t LogicalMinimum = 0;
  std::int64_t LogicalMaximum = 0;
  std::int64_t PhysicalMinimum = 0;
  std::int64_t PhysicalMaximum = 0;
  ///@}
  std::uint32_t Unit = 0; ///< unit, packed as in HID 1.11, 6.2.2.7; 0 if none
  /** Exponent of the unit: the value in Unit is the physical value * 10^UnitExponent. */
  int UnitExponent = 0;
  /** For an array, the index of its first usage in the list of choices. */
  std::uint32_t FirstChoice = 0;
  std::uint32_t ChoiceRanges = 0; ///< for an array, its number of usage ranges
};

/**
 * Returns the nearest value in the logical range that also fits in the field's bits, so that no
 * overflow changes the sign.
 */
std::int64_t ClampToField(const HidField& field, std::int64_t value) noexcept;

/**
 * Reads the field's bits, with their sign. If the payload is too short, returns false and sets the
 * value to 0.
 */
bool ReadRaw(const HidField& field, const std::uint8_t* payload, std::size_t size,
  std::int64_t& value) noexcept;

/**
 * Like ReadRaw, but also returns false for a value outside the logical range, which is HID's null
 * value ("no value").
 */
bool ReadValue(const HidField& field, const std::uint8_t* payload, std::size_t size,
  std::int64_t& value) noexcept;

/**
 * Writes the lowest bits of the value, whatever the logical range, and preserves all other bits. If
 * the payload is too short, returns false and writes nothing.
 */
bool WriteRaw(
  const HidField& field, std::uint8_t* payload, std::size_t size, std::int64_t value) noexcept;

/**
 * Writes the value, limited by ClampToField, and preserves all other bits. If the payload is too
 * short, returns false and writes nothing.
 */
bool WriteValue(
  const HidField& field, std::uint8_t* payload, std::size_t size, std::int64_t value) noexcept;

} // namespace VolumeHaptics

#endif
