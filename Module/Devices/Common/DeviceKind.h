// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A kind of device: it lists the devices that are plugged in, and makes a back end from an id.
 *
 * A program adds devices of its own by it: derive a back end from DeviceBackend, and hand a
 * DeviceKind to vtkHapticDevice::AddDeviceKind, as Examples/Cxx/OwnDevice.cxx does. Ids begin with
 * the kind's name, such as "falcon" or "falcon:1". A vendor's library that all programs are to use
 * is better reached by a plug-in, VendorPlugin.h.
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
 * Settings that the user makes before a device is opened; each kind takes those that concern it.
 */
struct DeviceOptions
{
  std::string FirmwareFile;  ///< an image to load into a device that has none
  double HomingTime = 120.0; ///< s, the longest time for each step of homing
  std::array<double, 2> NewtonsPerFullScale{ 100.0, 100.0 }; ///< N, of a stick's x and y
  /// the folders of plug-ins for vendors' libraries (VendorFolder.h); empty: the environment's
  std::string VendorPath;
  bool UseGuard = true; ///< for a device without a watchdog of its own (GuardedDevice.h)
};

/** A device that is plugged in. */
struct DeviceListing
{
  std::string Id;    ///< opens the device
  std::string Name;  ///< as the user sees it: maker, product, and its port
  std::string State; ///< "available", "in use", or the obstacle and its cure
  /// DeviceBackend::GetIdentity of the open device, if that is known before and KeepsIdentity is
  /// true; else empty
  std::string Identity = {};
};

struct DeviceKind
{
  /// Letters only, and no two kinds have the same. A built-in one may be the id of its only device.
  std::string Name;
  std::function<std::vector<DeviceListing>()> List;
  /** A back end for an id of this kind, not open yet. Null, with the reason and the cure. */
  std::function<std::unique_ptr<DeviceBackend>(
    const std::string& id, const DeviceOptions& options, std::string& error)>
    Make;
  /**
   * The reason why this computer can't have any device of this kind, such as a service that does
   * not run, a library or a port that is not found, and the cure. Empty if there is none. May be
   * null: then a device has to be plugged in, and no more.
   */
  std::function<std::string()> Missing = {};
};

} // namespace VolumeHaptics

#endif
