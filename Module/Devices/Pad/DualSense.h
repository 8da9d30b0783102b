// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The reports of Sony's DualSense and DualSense Edge.
 *
 * By cable, input reports have the number 1 and output reports the number 2. By Bluetooth, both
 * have the number 0x31 and end with a CRC-32, which also covers a virtual first byte for the
 * direction. By Bluetooth, a pad sends shortened reports until its calibration has been requested
 * once. The layout is that of Linux' driver, drivers/hid/hid-playstation.c, by Sony.
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
  /** Number of the feature report whose first request makes input reports complete. */
  static constexpr std::uint8_t CalibrationReport = 0x05;
  static constexpr std::uint8_t FirmwareReport = 0x20; ///< number of a feature report
  static constexpr std::size_t LongestReport = 78;

  enum class Link : std::uint8_t
  {
    Unknown,
    Cable,
    Bluetooth
  };

  static bool IsKnown(std::uint16_t vendor, std::uint16_t product) noexcept;

  /**
   * Reads a report with sticks and buttons, and determines the link from it. Returns nullptr, or
   * the reason why the report is not valid, as a static text; state and link are then unchanged.
   * Other reports are accepted and ignored.
   */
  static const char* Decode(
    const std::uint8_t* bytes, std::size_t size, Link& link, PadState& state) noexcept;

  /**
   * Returns whether the firmware supports the newer classic vibration: every Edge, and a DualSense
   * from version 2.21. `firmware` is the feature report FirmwareReport with its number.
   */
  static bool HasNewerVibration(
    std::uint16_t product, const std::uint8_t* firmware, std::size_t size) noexcept;

  struct Report
  {
    std::array<std::uint8_t, LongestReport> Bytes{};
    std::size_t Size = 0; ///< number of bytes; 0 if the link is unknown
  };
  /**
   * Encodes the speeds of the motors, 0 to 255. `number` counts the sent reports, which Bluetooth
   * needs.
   */
  static Report Encode(Link link, bool isNewer, int strong, int weak, unsigned number) noexcept;

  /** Computes the CRC-32 of IEEE 802.3 over a first byte and the bytes that follow it. */
  static std::uint32_t ComputeCrc(
    std::uint8_t first, const std::uint8_t* bytes, std::size_t size) noexcept;
};

} // namespace VolumeHaptics

#endif
