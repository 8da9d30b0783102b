// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Usb/UsbInterface.h"

namespace VolumeHaptics
{

UsbInterface::~UsbInterface()
{
  this->Close();
}

bool UsbInterface::Open(const UsbProduct& product, int number, std::string& error)
{
  this->Close();
  this->Context = MakeUsbContext(error);
  if (!this->Context)
  {
    return false;
  }
  const std::vector<UsbDevice> devices = FindUsbDevices(this->Context.get(), product);
  const auto place = static_cast<std::size_t>(number);
  if (place >= devices.size())
  {
    error = devices.empty()
      ? std::string("No ") + product.Name + " is plugged in. Plug it in, and switch its power on."
      : std::string("There is no ") + product.Name + " of number " + std::to_string(number) + ": " +
        std::to_string(devices.size()) + " are plugged in, counted from 0.";
    return false;
  }
  this->Device.reset(libusb_ref_device(devices[place].get()));
  const int result = this->Claim();
  if (result != LIBUSB_SUCCESS)
  {
    error = "The " + UsbNameOf(this->Device.get(), product) +
      " can't be opened: " + UsbTroubleText(result, product);
  }
  return result == LIBUSB_SUCCESS;
}

int UsbInterface::Reopen() noexcept
{
  this->Release();
  return this->Claim();
}

int UsbInterface::Claim() noexcept
{
  int result = libusb_open(this->Device.get(), &this->Handle);
  if (result == LIBUSB_SUCCESS)
  {
    // Systems without this function have no driver in the way either.
    libusb_set_auto_detach_kernel_driver(this->Handle, 1);
    result = libusb_claim_interface(this->Handle, 0);
  }
  if (result != LIBUSB_SUCCESS && this->Handle != nullptr)
  {
    libusb_close(this->Handle);
    this->Handle = nullptr;
  }
  return result;
}

void UsbInterface::Release() noexcept
{
  if (this->Handle != nullptr)
  {
    libusb_release_interface(this->Handle, 0);
    libusb_close(this->Handle);
    this->Handle = nullptr;
  }
}

void UsbInterface::Close() noexcept
{
  this->Release();
  this->Device.reset();
  this->Context.reset();
}

int UsbInterface::Control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
  std::uint16_t index, unsigned int time) noexcept
{
  return libusb_control_transfer(this->Handle, type, request, value, index, nullptr, 0, time);
}

int UsbInterface::Transfer(
  std::uint8_t endpoint, std::uint8_t* bytes, std::size_t size, unsigned int time) noexcept
{
  int done = 0;
  const int result =
    libusb_bulk_transfer(this->Handle, endpoint, bytes, static_cast<int>(size), &done, time);
  // Bytes that came within the time count.
  return result == LIBUSB_SUCCESS || (result == LIBUSB_ERROR_TIMEOUT && done > 0) ? done : result;
}

} // namespace VolumeHaptics
