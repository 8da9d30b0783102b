// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the carrier of the USB models: libusb talks to the models through a kernel that knows
 * nothing of emulation.
 */
#include "Emulators/SmallModels.h"
#include "Emulators/VirtualUsb.h"
#include "Waiting.h"

#include <libusb.h>

namespace machinetest
{
using namespace emulated;

/**
 * libusb's handle of a device, once the kernel has the device. Each handle has a new context,
 * because an old context learns of new devices only from udev's daemon, which does not run here.
 */
class UsbHandle
{
public:
  ~UsbHandle() { this->Close(); }

  bool Open()
  {
    this->Close();
    EXPECT_EQ(libusb_init(&this->Context), 0);
    this->Handle = libusb_open_device_with_vid_pid(this->Context, 0x1234, 1);
    return this->Handle != nullptr;
  }
  void Close()
  {
    if (this->Handle)
    {
      libusb_close(this->Handle);
      this->Handle = nullptr;
    }
    if (this->Context)
    {
      libusb_exit(this->Context);
      this->Context = nullptr;
    }
  }
  operator libusb_device_handle*() const { return this->Handle; }

private:
  libusb_context* Context = nullptr;
  libusb_device_handle* Handle = nullptr;
};

TEST(UsbCarrier, CarriesBulkTransfersAndRequests)
{
  EchoUsb model;
  VirtualUsb port(model, 0);
  port.Plug();
  UsbHandle handle;
  ASSERT_TRUE(Eventually([&] { return handle.Open(); }));
  ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
  EXPECT_EQ(libusb_control_transfer(handle, 0x40, 9, 1, 0, nullptr, 0, 5000), 0);
  unsigned char bytes[64] = {};
  EXPECT_EQ(libusb_control_transfer(handle, 0xC0, 5, 0, 0, bytes, 8, 5000), LIBUSB_ERROR_PIPE);

  int moved = 0;
  EXPECT_EQ(libusb_bulk_transfer(handle, 0x81, bytes, 64, &moved, 50), LIBUSB_ERROR_TIMEOUT)
    << "there is nothing yet, and the transfer was taken back";
  {
    const RateOf rate("bulk OUT and IN", 1000);
    for (unsigned i = 0; i < 1000; ++i)
    {
      unsigned char sent[16] = { static_cast<unsigned char>(i),
        static_cast<unsigned char>(i >> 8) };
      ASSERT_EQ(libusb_bulk_transfer(handle, 0x02, sent, 16, &moved, 5000), 0);
      ASSERT_EQ(libusb_bulk_transfer(handle, 0x81, bytes, 64, &moved, 5000), 0);
      ASSERT_EQ(moved, 16);
      ASSERT_EQ(std::memcmp(sent, bytes, 16), 0) << i;
    }
  }

  port.Unplug();
  EXPECT_EQ(libusb_bulk_transfer(handle, 0x81, bytes, 64, &moved, 5000), LIBUSB_ERROR_NO_DEVICE);
}

TEST(UsbCarrier, TakesADeviceAgain)
{
  EchoUsb model;
  VirtualUsb port(model, 2);
  UsbHandle handle;
  for (int i = 0; i < 3; ++i)
  {
    port.Plug();
    EXPECT_TRUE(Eventually([&] { return handle.Open(); }));
    port.Unplug();
    EXPECT_TRUE(Eventually([&] { return !handle.Open(); }));
  }
}
} // namespace machinetest
