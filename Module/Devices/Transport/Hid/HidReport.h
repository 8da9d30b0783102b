// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The bytes of a HID device's report.
 */
#ifndef HidReport_h
#define HidReport_h

#include "Devices/Transport/Hid/HidField.h"

#include <array>

namespace VolumeHaptics
{

/** A report to send, or to be filled with the device's data. */
struct HidReport
{
  static constexpr std::size_t Capacity = 64; ///< largest number of bytes of the payload

  HidReportKind Kind = HidReportKind::Output;
  std::size_t Size = 0; ///< number of bytes of the payload
  /// The id (0 if the device does not use ids), followed by the payload: Size + 1 bytes in total,
  /// as hidapi expects.
  std::array<std::uint8_t, Capacity + 1> Bytes{};
  std::uint8_t* Payload() noexcept { return this->Bytes.data() + 1; }
};

} // namespace VolumeHaptics

#endif
