// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the HID devices that are plugged in.
 */
#ifndef HidDeviceInfo_h
#define HidDeviceInfo_h

#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** An interface of a HID device that is plugged in, as the system lists it. */
struct HidDeviceInfo
{
  std::string Path; ///< path that opens the device; on Linux, its node
  std::string Maker;
  std::string Product; ///< name that the device reports
  std::uint16_t Vendor = 0;
  std::uint16_t ProductId = 0;
  std::uint16_t UsagePage = 0; ///< usage page of the first collection; 0 if unknown
  std::string Serial = {};     ///< serial number; empty if the device has none

  /** Returns maker, product and path, as shown to the user. */
  std::string GetLabel() const;
  /** Returns DeviceBackend::GetIdentity of the device: kind, vendor, product and serial number. */
  std::string MakeIdentity(const char* kind) const;
  /**
   * Returns DeviceBackend::KeepsIdentity: without a serial number, all devices of this model have
   * the same identity.
   */
  bool KeepsIdentity() const { return !this->Serial.empty(); }
  /** Returns whether this may be the same device: everything except the port is equal. */
  bool IsLike(const HidDeviceInfo& other) const
  {
    return this->Vendor == other.Vendor && this->ProductId == other.ProductId &&
      this->UsagePage == other.UsagePage && this->Serial == other.Serial &&
      this->Product == other.Product;
  }
  /** Returns the cure for a user without permission to open the device. */
  std::string GetPermissionCure() const;
  /** Returns "available", "in use", or the obstacle and its cure. */
  std::string GetState() const;
  /**
   * Reads and parses the report descriptor. On failure, returns false and writes the reason to
   * `error`.
   */
  bool ReadDescriptor(HidReportDescriptor& descriptor, std::string& error) const;
};

///@{
/**
 * List all devices, or those for which isSome returns true, in the order of the system's numbering.
 * May be called from any thread.
 */
std::vector<HidDeviceInfo> ListHidDevices();
std::vector<HidDeviceInfo> ListHidDevices(bool (*isSome)(const HidDeviceInfo&));
///@}

} // namespace VolumeHaptics

#endif
