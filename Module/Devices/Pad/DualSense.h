// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reports of Sony's DualSense and DualSense Edge.
 *
 * By cable, reports have the number 1 in and 2 out; by Bluetooth both have the number 0x31, and end
 * with their CRC-32, computed with a byte for their direction in front. A pad on Bluetooth sends
 * short reports until it is asked for its calibration once. The layout follows Linux' driver,
 * drivers/hid/hid-playstation.c, by Sony.
 */
#ifndef DualSense_h
#define DualSense_h

#include "Devices/Pad/PadState.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

class DualSense
{
public:
  static constexpr std::uint16_t Vendor = 0x054C;
  static constexpr std::uint16_t Product = 0x0CE6;
  static constexpr std::uint16_t EdgeProduct = 0x0DF2;
  static constexpr std::uint8_t CalibrationReport = 0x05; ///< reports are whole after its request
  static constexpr std::uint8_t FirmwareReport = 0x20;    ///< the id of a feature report
  static constexpr std::size_t LongestReport = 78;

  enum class Link : std::uint8_t
  {
    Unknown,
    Cable,
    Bluetooth
  };

  static bool IsKnown(std::uint16_t vendor, std::uint16_t product) noexcept;

  /**
   * Reads a report with sticks and buttons, and detects the link from it. Returns nullptr, or the
   * reason for refusing the report, as a text that lasts; state and link are then unchanged. Other
   * reports are accepted and change nothing.
   */
  static const char* Decode(
    const std::uint8_t* bytes, std::size_t size, Link& link, PadState& state) noexcept;

  /**
   * Returns whether the firmware has the newer classic vibration: an Edge has, a DualSense from
   * version 2.21 on. `firmware` is the feature report FirmwareReport, with its id.
   */
  static bool HasNewerVibration(
    std::uint16_t product, const std::uint8_t* firmware, std::size_t size) noexcept;

  struct Report
  {
    std::array<std::uint8_t, LongestReport> Bytes{};
    std::size_t Size = 0; ///< bytes of the report; 0 for an unknown link
  };
  /** Encodes the speeds of the motors, 0 to 255. `number` counts reports, for Bluetooth. */
  static Report Encode(Link link, bool isNewer, int strong, int weak, unsigned number) noexcept;

  /** Computes CRC-32 as in IEEE 802.3, over a first byte and the bytes after it. */
  static std::uint32_t ComputeCrc(
    std::uint8_t first, const std::uint8_t* bytes, std::size_t size) noexcept;
};

} // namespace VolumeHaptics

#endif
