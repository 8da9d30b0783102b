// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All kinds of devices that this process knows: the built-in ones and the added ones.
 */
#ifndef DeviceRegistry_h
#define DeviceRegistry_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

/**
 * Adds a kind. If the name is taken or invalid, or if the kind can't list or make devices, returns
 * false and writes the reason to `error`. Any thread.
 */
bool AddDeviceKind(const DeviceKind& kind, std::string& error);

/** Lists every device that is plugged in, in the order of the kinds. */
std::vector<DeviceListing> ListDevices();

/** The reason why this computer has no devices of a kind. */
struct DeviceObstacle
{
  std::string Kind;
  std::string Text; ///< the obstacle and its cure
};

/** Lists the kinds that this computer can't have, in order, by DeviceKind::Missing. */
std::vector<DeviceObstacle> ListMissingKinds();

/**
 * Makes a back end for an id, not open yet. If this fails, returns null and writes the reason and
 * the cure to `error`.
 */
std::unique_ptr<DeviceBackend> MakeDevice(
  const std::string& id, const DeviceOptions& options, std::string& error);

} // namespace VolumeHaptics

#endif
