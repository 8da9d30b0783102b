// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the carrier of the HID models: hidapi talks to the models through a kernel that knows
 * nothing of emulation.
 */
#include "Emulators/HidOverUsb.h"
#include "Emulators/SmallModels.h"
#include "Emulators/VirtualUsb.h"
#include "Waiting.h"

#include <hidapi.h>

namespace machinetest
{
using namespace emulated;

class HidCarrier : public testing::TestWithParam<bool>
{
};

TEST_P(HidCarrier, CarriesReports)
{
  EchoHid model(GetParam());
  HidOverUsb usb(model);
  VirtualUsb port(usb, 1);
  port.Plug();
  const std::uint8_t id = GetParam() ? 5 : 0;
  hid_device* device = nullptr;
  ASSERT_TRUE(Eventually(
    [&] { return (device = hid_open(0x1234, model.GetProduct(), nullptr)) != nullptr; }));
  wchar_t name[100] = {};
  EXPECT_EQ(hid_get_product_string(device, name, 100), 0);
  EXPECT_EQ(std::wstring(name), GetParam() ? L"Echo with ids" : L"Echo");

  const unsigned char feature[5] = { id, 1, 2, 3, 4 };
  EXPECT_EQ(hid_send_feature_report(device, feature, 5), 5);
  unsigned char back[65] = { id };
  EXPECT_EQ(hid_get_feature_report(device, back, 5), 5);
  EXPECT_EQ(std::memcmp(back, feature, 5), 0);

  const int front = GetParam() ? 0 : 1; // if the device uses ids, the id precedes an input report
  {
    const RateOf rate("HID output and input", 1000);
    for (unsigned i = 0; i < 1000; ++i)
    {
      const unsigned char sent[5] = { id, static_cast<unsigned char>(i),
        static_cast<unsigned char>(i >> 8), 7, 8 };
      ASSERT_EQ(hid_write(device, sent, 5), 5);
      ASSERT_EQ(hid_read_timeout(device, back, sizeof(back), 5000), 5 - front);
      ASSERT_EQ(std::memcmp(sent + front, back, 5 - front), 0) << i;
    }
  }

  port.Unplug();
  EXPECT_EQ(hid_read_timeout(device, back, sizeof(back), 5000), -1);
  const unsigned char lost[5] = { id };
  EXPECT_EQ(hid_write(device, lost, 5), -1);
  hid_close(device);
}

INSTANTIATE_TEST_SUITE_P(Ids, HidCarrier, testing::Bool());
} // namespace machinetest
