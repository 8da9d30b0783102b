// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The registry of all kinds of devices in this process, built-in and added ones.
 */
#ifndef DeviceRegistry_h
#define DeviceRegistry_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

/**
 * Adds a kind. May be called from any thread. Returns false and writes the reason to `error` if the
 * name is taken or not valid, or if the kind lacks a function to list or make devices.
 */
bool AddDeviceKind(const DeviceKind& kind, std::string& error);

/** Lists all devices that are plugged in, in the order of the kinds. */
std::vector<DeviceListing> ListDevices();

/** The reason why this computer has no devices of a kind. */
struct DeviceObstacle
{
  std::string Kind;
  std::string Text; ///< the obstacle and its cure
};

/** Lists the kinds whose DeviceKind::Missing returns an obstacle, in the order of the kinds. */
std::vector<DeviceObstacle> ListMissingKinds();

/**
 * Makes a back end for an id, without opening it. On failure, returns null and writes the reason
 * and the cure to `error`.
 */
std::unique_ptr<DeviceBackend> MakeDevice(
  const std::string& id, const DeviceOptions& options, std::string& error);

} // namespace VolumeHaptics

#endif
