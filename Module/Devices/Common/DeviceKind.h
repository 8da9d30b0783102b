// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A kind of device: it lists the devices that are plugged in, and makes a back end from an id.
 *
 * A program can add its own devices: derive a back end from DeviceBackend, and pass a DeviceKind to
 * vtkHapticDevice::AddDeviceKind, as Examples/Cxx/OwnDevice.cxx does. Ids begin with the kind's
 * name, such as "falcon" or "falcon:1". For a vendor's library that all programs should use, write
 * a plug-in: VendorPlugin.h.
 */
#ifndef DeviceKind_h
#define DeviceKind_h

#include "Core/Safety/DeviceBackend.h"

#include <functional>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** Settings that the user makes before a device is opened; each kind uses those that concern it. */
struct DeviceOptions
{
  std::string FirmwareFile;  ///< the firmware's image for a device that has none loaded
  double HomingTime = 120.0; ///< s, the longest time for each step of homing
  std::array<double, 2> NewtonsPerFullScale{ 100.0, 100.0 }; ///< N, along a stick's x and y
  /// the folders of plug-ins for vendors' libraries (VendorFolder.h); empty: those of the
  /// environment variable
  std::string VendorPath;
  bool UseGuard = true; ///< guards a device without its own watchdog (GuardedDevice.h)
};

/** A device that is plugged in. */
struct DeviceListing
{
  std::string Id;    ///< opens the device
  std::string Name;  ///< name for people: maker, product, and port
  std::string State; ///< "available", "in use", or the obstacle and its cure
  /// DeviceBackend::GetIdentity of the open device, if it is known before the device is opened and
  /// KeepsIdentity is true; else empty
  std::string Identity = {};
};

struct DeviceKind
{
  /// Letters only; unique among the kinds. A built-in kind's name may be the id of its only device.
  std::string Name;
  std::function<std::vector<DeviceListing>()> List;
  /**
   * Makes a back end for an id of this kind, not open yet. If this fails, returns null and writes
   * the reason and the cure to `error`.
   */
  std::function<std::unique_ptr<DeviceBackend>(
    const std::string& id, const DeviceOptions& options, std::string& error)>
    Make;
  /**
   * Returns the reason why this computer can't have any device of this kind, such as a service that
   * does not run, or a missing library or port, and the cure. Empty if there is no obstacle. The
   * function may be null: then plugging in a device is enough.
   */
  std::function<std::string()> Missing = {};
};

} // namespace VolumeHaptics

#endif
