// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A report of a HID device, as bytes.
 */
#ifndef HidReport_h
#define HidReport_h

#include "Devices/Transport/Hid/HidField.h"

#include <array>

namespace VolumeHaptics
{

/** Bytes to send, or to have filled by the device. */
struct HidReport
{
  static constexpr std::size_t Capacity = 64; ///< bytes of the payload

  HidReportKind Kind = HidReportKind::Output;
  std::size_t Size = 0; ///< bytes of the payload
  /// The id (0 without ids), then the payload: Size + 1 bytes, as hidapi expects.
  std::array<std::uint8_t, Capacity + 1> Bytes{};
  std::uint8_t* Payload() noexcept { return this->Bytes.data() + 1; }
};

} // namespace VolumeHaptics

#endif
