// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interface 0 of an open USB device, claimed for this object alone.
 */
#ifndef UsbInterface_h
#define UsbInterface_h

#include "Devices/Transport/Usb/UsbDevices.h"

#include <cstddef>

namespace VolumeHaptics
{

class UsbInterface
{
public:
  UsbInterface() = default;
  ~UsbInterface();
  UsbInterface(const UsbInterface&) = delete;
  UsbInterface& operator=(const UsbInterface&) = delete;

  /**
   * Opens the device with a number in FindUsbDevices, detaches a kernel driver until Close, and
   * claims interface 0. False, with the reason and the cure.
   */
  bool Open(const UsbProduct& product, int number, std::string& error);
  /**
   * Closes the device and opens the same one again: 0, or a negative libusb error; then it is not
   * open, and may be tried again.
   */
  int Reopen() noexcept;
  void Close() noexcept;
  bool IsOpen() const noexcept { return this->Handle != nullptr; }

  ///@{
  /**
   * Each waits until it is done or the time (ms) is over. Returns the size, or a negative libusb
   * error.
   */
  int Control(std::uint8_t type, std::uint8_t request, std::uint16_t value, std::uint16_t index,
    unsigned int time) noexcept;
  int Transfer(
    std::uint8_t endpoint, std::uint8_t* bytes, std::size_t size, unsigned int time) noexcept;
  ///@}

  /** Call it after a stall. */
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
