// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests hidapi from 0.14 on, which returns report descriptors that the system does not provide. A
 * stand-in replaces the library (Emulators/Hidapi), and the module's sources are compiled as on
 * such a system.
 */

#include "Devices/Transport/Hid/HidDeviceInfo.h"

#include <hidapi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

using namespace VolumeHaptics;

struct hid_device
{
  int Opened = 0;
};

namespace
{
/// Descriptor of a stick with one axis: X from 0 to 255 in eight bits.
const std::vector<unsigned char> Stick{ 0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x09, 0x30, 0x15, 0x00,
  0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0xC0 };
hid_device Device;
int Size = 0; ///< result of the simulated library: bytes, or -1
} // namespace

int hid_init()
{
  return 0;
}
hid_device_info* hid_enumerate(unsigned short, unsigned short)
{
  return nullptr;
}
void hid_free_enumeration(hid_device_info*) {}
hid_device* hid_open_path(const char* path)
{
  Device.Opened += std::strcmp(path, "stick") == 0 ? 1 : 0;
  return std::strcmp(path, "stick") == 0 ? &Device : nullptr;
}
void hid_close(hid_device* device)
{
  Device.Opened -= device != nullptr ? 1 : 0;
}
int hid_get_report_descriptor(hid_device*, unsigned char* bytes, std::size_t size)
{
  std::copy_n(Stick.begin(), std::min(size, Stick.size()), bytes);
  return Size;
}

TEST(NewerHidapi, HandsOutTheDescriptor)
{
  HidDeviceInfo info;
  info.Path = "stick";
  Size = static_cast<int>(Stick.size());
  HidReportDescriptor descriptor;
  std::string error;
  EXPECT_TRUE(info.ReadDescriptor(descriptor, error)) << error;
  ASSERT_EQ(descriptor.GetFields().size(), 1U);
  EXPECT_EQ(descriptor.GetReportSize(HidReportKind::Input, 0), 1U);
  EXPECT_EQ(Device.Opened, 0) << "and it is closed again";
}

TEST(NewerHidapi, ADeviceThatHandsOutNoneIsRefused)
{
  HidDeviceInfo info;
  HidReportDescriptor descriptor;
  for (const int size : { -1, 0 })
  {
    std::string error;
    info.Path = "stick";
    Size = size;
    EXPECT_FALSE(info.ReadDescriptor(descriptor, error));
    EXPECT_EQ(error,
      "the system does not hand out the report descriptor (other systems than Linux need hidapi "
      "0.14 or later)");
  }
  std::string error;
  info.Path = "unplugged";
  EXPECT_FALSE(info.ReadDescriptor(descriptor, error));
  EXPECT_EQ(Device.Opened, 0);
}
