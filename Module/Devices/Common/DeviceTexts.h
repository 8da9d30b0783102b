// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions and texts that all kinds of devices share: reading ids, and explaining why a device
 * can't be opened.
 */
#ifndef DeviceTexts_h
#define DeviceTexts_h

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Text, after the device's name, for an unplugged device that the driver will find again. */
constexpr const char* UnpluggedText =
  "was unplugged. Plug it in again: it is opened by itself, and waits for Arm().";
/** Text, after the device's name, for an unplugged device that can't be told from another one. */
constexpr const char* OpenAgainText = "was unplugged. Plug it in, then Open() and Start() it.";

///@{
/**
 * Returns the number N of an id KIND:N, or 0 for an id KIND. For any other id, returns a negative
 * number and writes the fault to `error`.
 */
int ReadDeviceNumber(const std::string& id, const std::string& kind, std::string& error);
/**
 * Returns the cure if this user lacks permission to open a device: a udev rule. `subsystem` is
 * "usb" or "hidraw". Over Bluetooth, no USB device has these numbers, so the rule names the
 * kernel's device.
 */
std::string PermissionCure(
  const char* subsystem, std::uint16_t vendor, std::uint16_t product, bool isBluetooth = false);
///@}

} // namespace VolumeHaptics

#endif
