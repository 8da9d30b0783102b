// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The plugged-in USB devices of a product, their ports, and whether they are free.
 */
#ifndef UsbDevices_h
#define UsbDevices_h

#include <libusb.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace VolumeHaptics
{

///@{
/**
 * libusb's handles, released automatically. A device uses its context's memory: destroy it first.
 */
struct UsbContextEnd
{
  void operator()(libusb_context* context) const noexcept { libusb_exit(context); }
};
struct UsbDeviceEnd
{
  void operator()(libusb_device* device) const noexcept { libusb_unref_device(device); }
};
using UsbContext = std::unique_ptr<libusb_context, UsbContextEnd>;
using UsbDevice = std::unique_ptr<libusb_device, UsbDeviceEnd>;
///@}

struct UsbProduct
{
  std::uint16_t Vendor;
  std::uint16_t Product;
  const char* Name; ///< for people: maker and product
};

/** Null, with the reason, if the system's USB can't be reached. */
UsbContext MakeUsbContext(std::string& error);

/** The devices of a product, in the order of their bus and of the ports on the way to them. */
std::vector<UsbDevice> FindUsbDevices(libusb_context* context, const UsbProduct& product);

/** The name that the user sees, such as "Novint Falcon (USB bus 1, port 2.4)". */
std::string UsbNameOf(libusb_device* device, const UsbProduct& product);

/**
 * DeviceBackend::GetIdentity for a device of a kind: the kind, and the serial number if the device
 * has one and may be opened.
 */
std::string UsbIdentityOf(libusb_device* device, const char* kind);

/**
 * Whether interface 0 could be claimed now: "available", "in use", or the obstacle and the cure.
 * Sends nothing to the device, and leaves a kernel driver bound.
 */
std::string UsbStateOf(libusb_device* device, const UsbProduct& product);

/** The obstacle and the cure, if opening or claiming gave this error of libusb. */
std::string UsbTroubleText(int error, const UsbProduct& product);

} // namespace VolumeHaptics

#endif
