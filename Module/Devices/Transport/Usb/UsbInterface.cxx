// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Usb/UsbInterface.h"

#include "Devices/Common/DeviceTexts.h"

#include <algorithm>

namespace VolumeHaptics
{

std::vector<int> UsbPathOf(libusb_device* device)
{
  std::uint8_t ports[7]; // USB has at most seven tiers
  const int count = libusb_get_port_numbers(device, ports, static_cast<int>(std::size(ports)));
  std::vector<int> path{ libusb_get_bus_number(device) };
  path.insert(path.end(), ports, ports + std::max(count, 0));
  // An emulated device may have no ports; its address then identifies it.
  path.push_back(libusb_get_device_address(device));
  return path;
}

UsbContext MakeUsbContext(std::string& error)
{
  libusb_context* context = nullptr;
  const int result = libusb_init(&context);
  if (result != LIBUSB_SUCCESS)
  {
    error = std::string("The system's USB can't be reached: ") + libusb_strerror(result) + ".";
    return nullptr;
  }
  return UsbContext(context);
}

std::vector<UsbDevice> ListUsbDevices(libusb_context* context, const UsbProduct& product)
{
  std::vector<UsbDevice> found;
  libusb_device** list = nullptr;
  const ssize_t count = libusb_get_device_list(context, &list);
  for (ssize_t i = 0; i < count; ++i)
  {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(list[i], &descriptor) == LIBUSB_SUCCESS &&
      descriptor.idVendor == product.Vendor && descriptor.idProduct == product.Product)
    {
      found.emplace_back(libusb_ref_device(list[i]));
    }
  }
  if (count >= 0)
  {
    libusb_free_device_list(list, 1);
  }
  std::sort(found.begin(), found.end(),
    [](const UsbDevice& a, const UsbDevice& b) { return UsbPathOf(a.get()) < UsbPathOf(b.get()); });
  return found;
}

std::string UsbNameOf(libusb_device* device, const UsbProduct& product)
{
  const std::vector<int> path = UsbPathOf(device);
  std::string name = product.Name + std::string(" (USB bus ") + std::to_string(path.front());
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    name += (i == 1 ? ", port " : ".") + std::to_string(path[i]);
  }
  return name + ")";
}

std::string UsbIdentityOf(libusb_device* device, const char* kind, bool* isSure)
{
  libusb_device_descriptor descriptor{};
  libusb_device_handle* handle = nullptr;
  std::string number;
  const bool hasNumber = libusb_get_device_descriptor(device, &descriptor) == LIBUSB_SUCCESS &&
    descriptor.iSerialNumber != 0;
  if (hasNumber && libusb_open(device, &handle) == LIBUSB_SUCCESS)
  {
    unsigned char serial[128];
    const int size =
      libusb_get_string_descriptor_ascii(handle, descriptor.iSerialNumber, serial, sizeof(serial));
    if (size > 0)
    {
      number = std::string(serial, serial + size);
    }
    libusb_close(handle);
  }
  if (isSure != nullptr)
  {
    *isSure = !hasNumber || !number.empty();
  }
  if (number.empty())
  {
    const std::vector<int> path = UsbPathOf(device);
    number = "port:" + std::to_string(path.front());
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      number += (i == 1 ? "-" : ".") + std::to_string(path[i]);
    }
  }
  return kind + (":" + number);
}

std::string UsbStateOf(libusb_device* device, const UsbProduct& product)
{
  libusb_device_handle* handle = nullptr;
  int result = libusb_open(device, &handle);
  if (result != LIBUSB_SUCCESS)
  {
    return UsbTroubleText(result, product);
  }
  // Opening the device detaches a driver of the kernel, so test whether the interface can be
  // claimed only if there is none.
  if (libusb_kernel_driver_active(handle, 0) != 1)
  {
    result = libusb_claim_interface(handle, 0);
    if (result == LIBUSB_SUCCESS)
    {
      libusb_release_interface(handle, 0);
    }
  }
  libusb_close(handle);
  return result == LIBUSB_SUCCESS ? "available"
    : result == LIBUSB_ERROR_BUSY ? "in use"
                                  : UsbTroubleText(result, product);
}

std::string UsbTroubleText(int error, const UsbProduct& product)
{
  switch (error)
  {
    case LIBUSB_ERROR_ACCESS:
      return PermissionCure("usb", product.Vendor, product.Product);
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      return "it is no longer plugged in. Plug it in again.";
    case LIBUSB_ERROR_BUSY:
      return "it is in use by another program, or opened a second time by this one. Close it "
             "there.";
    default:
      return std::string("the system refuses it (libusb: ") + libusb_strerror(error) +
        "). Unplug it, plug it in again, and look into the system's log.";
  }
}

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
  const std::vector<UsbDevice> devices = ListUsbDevices(this->Context.get(), product);
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
    // Systems that lack this function have no driver that needs to be detached.
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
  // Bytes that arrived before the time-out are valid.
  return result == LIBUSB_SUCCESS || (result == LIBUSB_ERROR_TIMEOUT && done > 0) ? done : result;
}

} // namespace VolumeHaptics
