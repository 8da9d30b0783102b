// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the USB devices of a product that are plugged in, and claims interface 0 of a device for
 * one object.
 */
#ifndef UsbInterface_h
#define UsbInterface_h

#include <cstddef>
#include <cstdint>
#include <libusb.h>
#include <memory>
#include <string>
#include <vector>

namespace VolumeHaptics
{

///@{
/**
 * Handles of libusb that are released automatically. A device uses its context's memory, so it must
 * be destroyed before the context.
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
  const char* Name; ///< name for the user: maker and product
};

/**
 * Makes a context. On failure to access the system's USB, returns null and writes the reason to
 * `error`.
 */
UsbContext MakeUsbContext(std::string& error);

/** Lists the devices of a product, sorted by bus and by the ports that lead to them. */
std::vector<UsbDevice> ListUsbDevices(libusb_context* context, const UsbProduct& product);

/** Returns the name for the user, such as "Novint Falcon (USB bus 1, port 2.4)". */
std::string UsbNameOf(libusb_device* device, const UsbProduct& product);

/**
 * Returns DeviceBackend::GetIdentity of a device: its kind, and its serial number if it can be
 * read, otherwise its port. `isSure` receives false if the device has a serial number that can't be
 * read.
 */
std::string UsbIdentityOf(libusb_device* device, const char* kind, bool* isSure = nullptr);

/** Returns the bus of a device, the ports that lead to it, and its address on the bus. */
std::vector<int> UsbPathOf(libusb_device* device);

/**
 * Returns whether interface 0 can be claimed now: "available", "in use", or the obstacle and the
 * cure. Sends nothing to the device, and detaches no driver of the kernel.
 */
std::string UsbStateOf(libusb_device* device, const UsbProduct& product);

/**
 * Returns the obstacle and the cure for a libusb error that occurred when opening or claiming a
 * device.
 */
std::string UsbTroubleText(int error, const UsbProduct& product);

class UsbInterface
{
public:
  UsbInterface() = default;
  ~UsbInterface();
  UsbInterface(const UsbInterface&) = delete;
  UsbInterface& operator=(const UsbInterface&) = delete;

  /**
   * Opens the device with the index `number` in ListUsbDevices and claims its interface 0. Detaches
   * a driver of the kernel until Close(). On failure, returns false and writes the reason and the
   * cure to `error`.
   */
  bool Open(const UsbProduct& product, int number, std::string& error);
  /**
   * Closes and reopens the device. Returns 0, or a negative libusb error; the device is then
   * closed, and Reopen() may be tried again.
   */
  int Reopen() noexcept;
  void Close() noexcept;
  bool IsOpen() const noexcept { return this->Handle != nullptr; }

  ///@{
  /**
   * Carry out a transfer. Wait for at most `time` (ms) until it is done. Return its size, or a
   * negative libusb error.
   */
  int Control(std::uint8_t type, std::uint8_t request, std::uint16_t value, std::uint16_t index,
    unsigned int time) noexcept;
  int Transfer(
    std::uint8_t endpoint, std::uint8_t* bytes, std::size_t size, unsigned int time) noexcept;
  ///@}

  /** Clears the halt of an endpoint. Must be called after a stall. */
  void ClearHalt(std::uint8_t endpoint) noexcept { libusb_clear_halt(this->Handle, endpoint); }

  libusb_context* GetContext() const noexcept { return this->Context.get(); }
  libusb_device_handle* GetHandle() const noexcept { return this->Handle; }

private:
  int Claim() noexcept;
  void Release() noexcept;

  UsbContext Context;
  UsbDevice Device;
  libusb_device_handle* Handle = nullptr;
};

} // namespace VolumeHaptics

#endif
