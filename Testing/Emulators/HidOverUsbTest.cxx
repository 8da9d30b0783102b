// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests a kernel's requests to a HID device over USB, with and without report ids. */
#include "HidOverUsb.h"
#include "PlayedKernel.h"
#include "SmallModels.h"

namespace machinetest
{
class HidOverUsbTest : public testing::TestWithParam<bool>
{
protected:
  /// Returns a report's bytes as transmitted: without the id, if the device uses no ids.
  static Bytes Wire(Bytes report)
  {
    report.erase(report.begin(), report.begin() + (GetParam() ? 0 : 1));
    return report;
  }
  static std::uint8_t Id() { return GetParam() ? 5 : 0; }

  EchoHid Model{ GetParam() };
  emulated::HidOverUsb Usb{ this->Model };
  PlayedKernel Kernel{ this->Usb };
};

TEST_P(HidOverUsbTest, DescribesItself)
{
  const Bytes all = this->Usb.GetDescriptors();
  ASSERT_EQ(all.size(), 18u + 41u);
  EXPECT_EQ(all[18 + 2], 41) << "the configuration knows its size";
  EXPECT_EQ(all[10], GetParam() ? 3 : 2) << "product";
  const Bytes report = this->Model.GetReportDescriptor();
  EXPECT_EQ(all[18 + 9 + 9 + 7], report.size());
  EXPECT_EQ(this->Kernel.Request({ 0x81, 6, 0, 0x22, 0, 0, 0xFF, 0 }).Data, report);
  EXPECT_EQ(this->Kernel.Request({ 0x80, 6, 0, 3, 0, 0, 0xFF, 0 }).Data, Bytes({ 4, 3, 9, 4 }));
  const Bytes name = this->Kernel.Request({ 0x80, 6, 2, 3, 9, 4, 0xFF, 0 }).Data;
  ASSERT_EQ(name.size(), 2 + 2 * this->Model.GetName().size());
  EXPECT_EQ(name[0], name.size());
  EXPECT_EQ(Bytes(name.begin() + 2, name.begin() + 6), Bytes({ 'E', 0, 'c', 0 }));
  EXPECT_EQ(this->Kernel.Request({ 0x80, 6, 3, 3, 9, 4, 0xFF, 0 }).Status, -EPIPE);
}

TEST_P(HidOverUsbTest, CarriesFeatures)
{
  const Bytes wire = Wire({ Id(), 1, 2, 3, 4 });
  const auto size = static_cast<std::uint8_t>(wire.size());
  EXPECT_EQ(this->Kernel.Request({ 0x21, 9, Id(), 3, 0, 0, size, 0 }, wire).Status, 0);
  EXPECT_EQ(this->Kernel.Request({ 0xA1, 1, Id(), 3, 0, 0, 64, 0 }).Data, wire);
  EXPECT_EQ(this->Kernel.Request({ 0xA1, 1, Id(), 3, 0, 0, 2, 0 }).Data.size(), 2u);
  EXPECT_EQ(this->Kernel.Request({ 0xA1, 1, Id(), 1, 0, 0, 64, 0 }).Status, -EPIPE)
    << "inputs come by themselves";
}

TEST_P(HidOverUsbTest, CarriesReports)
{
  const Bytes wire = Wire({ Id(), 6, 7, 8, 9 });
  ASSERT_TRUE(this->Kernel.Out(1, 2, wire));
  EXPECT_EQ(this->Kernel.Receive(false).Status, 0);
  ASSERT_TRUE(this->Kernel.In(2, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Data, wire);

  // An output report may also be sent as a control request.
  const auto size = static_cast<std::uint8_t>(wire.size());
  EXPECT_EQ(this->Kernel.Request({ 0x21, 9, Id(), 2, 0, 0, size, 0 }, wire).Status, 0);
  ASSERT_TRUE(this->Kernel.In(3, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Data, wire);
}

TEST_P(HidOverUsbTest, KeepsWhatIsNew)
{
  for (std::uint8_t i = 0; i < 200; ++i)
  {
    this->Model.Input(&i, 1);
  }
  ASSERT_TRUE(this->Kernel.In(1, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Data, Bytes({ 200 - 64 }));
  this->Usb.Forget();
  ASSERT_TRUE(this->Kernel.In(2, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Command, 0u);
}

INSTANTIATE_TEST_SUITE_P(Ids, HidOverUsbTest, testing::Bool());
} // namespace machinetest
