// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All kinds of devices that this process knows: those that were built in, and those that were
 * added.
 */
#ifndef DeviceRegistry_h
#define DeviceRegistry_h

#include "Devices/Common/DeviceKind.h"

namespace VolumeHaptics
{

/**
 * False, with the reason, where the name is taken or no name, or the kind can't list or make. Any
 * thread.
 */
bool AddDeviceKind(const DeviceKind& kind, std::string& error);

/** Every device that is plugged in, in the order of the kinds. */
std::vector<DeviceListing> ListDevices();

/** A back end for an id, not open yet. Null, with the reason and the cure. */
std::unique_ptr<DeviceBackend> MakeDevice(
  const std::string& id, const DeviceOptions& options, std::string& error);

///@{
/**
 * For kinds: the number N of an id KIND:N, 0 of KIND alone; below zero, with an error, for another
 * id.
 */
int ReadDeviceNumber(const std::string& id, const std::string& kind, std::string& error);
/**
 * What to do about a device that this user may not open: the udev rule, to the letter. The
 * subsystem is "usb" or "hidraw".
 */
std::string PermissionCure(const char* subsystem, std::uint16_t vendor, std::uint16_t product);
///@}

} // namespace VolumeHaptics

#endif
