// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A kind of device: lists the devices that are plugged in, and makes a back end from an id.
 *
 * A program can add its own devices: derive a back end from DeviceBackend, and pass a DeviceKind to
 * vtkHapticDevice::AddDeviceKind, as Examples/Cxx/OwnDevice.cxx does. Ids begin with the kind's
 * name, such as "falcon" or "falcon:1". For a vendor's library that all programs should use, write
 * a plug-in (VendorPlugin.h).
 */
#ifndef DeviceKind_h
#define DeviceKind_h

#include "Core/Safety/DeviceBackend.h"

#include <functional>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/**
 * Settings that the user makes before a device is opened. Each kind uses the settings that concern
 * it.
 */
struct DeviceOptions
{
  std::string FirmwareFile;  ///< firmware image for a device that has no firmware loaded
  double HomingTime = 120.0; ///< longest time (s) for each step of homing
  /** Force (N) of a stick at full scale, along x and y. */
  std::array<double, 2> NewtonsPerFullScale{ 100.0, 100.0 };
  /// Folders of plug-ins for vendors' libraries (VendorFolder.h). If empty, the folders in the
  /// environment variable are used.
  std::string VendorPath;
  /** Whether a guard communicates with a device that has no watchdog (GuardedDevice.h). */
  bool UseGuard = true;
};

/** A device that is plugged in. */
struct DeviceListing
{
  std::string Id;    ///< id that opens the device
  std::string Name;  ///< readable name: maker, product and port
  std::string State; ///< "available", "in use", or the obstacle and its cure
  /// DeviceBackend::GetIdentity of the open device, if it is known before opening and KeepsIdentity
  /// returns true. Otherwise empty.
  std::string Identity = {};
};

struct DeviceKind
{
  /// Name of the kind: only letters, and unique. Only names of built-in kinds may contain a colon,
  /// such as "vibration:xr".
  std::string Name;
  std::function<std::vector<DeviceListing>()> List;
  /**
   * Makes a back end for an id of this kind, without opening it. On failure, returns null and
   * writes the reason and the cure to `error`.
   */
  std::function<std::unique_ptr<DeviceBackend>(
    const std::string& id, const DeviceOptions& options, std::string& error)>
    Make;
  /**
   * Returns the reason why this computer can't have any device of this kind, and the cure. Typical
   * reasons are a service that does not run, or a missing library or port. Returns an empty text if
   * there is no obstacle. If the function is null, plugging in a device is enough.
   */
  std::function<std::string()> Missing = {};
};

} // namespace VolumeHaptics

#endif
