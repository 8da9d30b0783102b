// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the device's side of USB/IP. The test simulates the kernel's side. */
#include "PlayedKernel.h"
#include "SmallModels.h"

namespace machinetest
{
class UsbIpTest : public testing::Test
{
protected:
  EchoUsb Model;
  PlayedKernel Kernel{ this->Model };
};

TEST_F(UsbIpTest, HandsOutDescriptors)
{
  const Bytes all = this->Model.GetDescriptors();
  const Reply device = this->Kernel.Request({ 0x80, 6, 0, 1, 0, 0, 64, 0 });
  EXPECT_EQ(device.Data, Bytes(all.begin(), all.begin() + 18));
  const Reply beginning = this->Kernel.Request({ 0x80, 6, 0, 1, 0, 0, 8, 0 });
  EXPECT_EQ(beginning.Data, Bytes(all.begin(), all.begin() + 8)) << "no more than is asked for";
  const Reply configuration = this->Kernel.Request({ 0x80, 6, 0, 2, 0, 0, 0xFF, 0 });
  EXPECT_EQ(configuration.Data, Bytes(all.begin() + 18, all.end()));
}

TEST_F(UsbIpTest, TakesWhatEveryDeviceTakes)
{
  EXPECT_EQ(this->Kernel.Request({ 0x00, 9, 1, 0, 0, 0, 0, 0 }).Status, 0) << "configuration";
  EXPECT_EQ(this->Kernel.Request({ 0x02, 1, 0, 0, 0x81, 0, 0, 0 }).Status, 0) << "halt cleared";
  EXPECT_EQ(this->Kernel.Request({ 0x80, 0, 0, 0, 0, 0, 2, 0 }).Data, Bytes(2)) << "status";
  EXPECT_EQ(this->Kernel.Request({ 0x40, 9, 1, 0, 0, 0, 0, 0 }).Status, 0) << "the model's own";
  const Reply stall = this->Kernel.Request({ 0xC0, 9, 1, 0, 0, 0, 8, 0 });
  EXPECT_EQ(stall.Status, -EPIPE);
  EXPECT_TRUE(stall.Data.empty());
}

TEST_F(UsbIpTest, LetsTransfersWait)
{
  ASSERT_TRUE(this->Kernel.In(1, 1, 64));
  ASSERT_TRUE(this->Kernel.In(2, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Command, 0u) << "the model has nothing yet";

  ASSERT_TRUE(this->Kernel.Out(3, 2, { 7, 8, 9 }));
  const Reply out = this->Kernel.Receive(false);
  EXPECT_EQ(out.Number, 3u);
  EXPECT_EQ(out.Status, 0);
  const Reply in = this->Kernel.Receive(true);
  EXPECT_EQ(in.Number, 1u) << "the one that has waited longest";
  EXPECT_EQ(in.Data, Bytes({ 7, 8, 9 }));

  // Let the model send a report while a transfer waits.
  const std::uint8_t byte = 5;
  this->Model.Out(2, &byte, 1);
  EXPECT_TRUE(this->Kernel.GetDevice().AnswerWaiting());
  EXPECT_EQ(this->Kernel.Receive(true).Number, 2u);
}

TEST_F(UsbIpTest, LetsTransfersOutWait)
{
  this->Model.HasRoom = false;
  ASSERT_TRUE(this->Kernel.Out(1, 2, { 4 }));
  ASSERT_TRUE(this->Kernel.Out(2, 2, { 5 }));
  EXPECT_EQ(this->Kernel.Receive(false).Command, 0u);
  ASSERT_TRUE(this->Kernel.Unlink(3, 1));
  EXPECT_EQ(this->Kernel.Receive(false).Status, -ECONNRESET);
  this->Model.HasRoom = true;
  EXPECT_TRUE(this->Kernel.GetDevice().AnswerWaiting());
  EXPECT_EQ(this->Kernel.Receive(false).Number, 2u);
  ASSERT_TRUE(this->Kernel.In(4, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Data, Bytes({ 5 })) << "what was taken back never came";
}

TEST_F(UsbIpTest, GivesTransfersBack)
{
  ASSERT_TRUE(this->Kernel.In(1, 1, 64));
  ASSERT_TRUE(this->Kernel.Unlink(2, 1));
  Reply reply = this->Kernel.Receive(false);
  EXPECT_EQ(reply.Command, 4u);
  EXPECT_EQ(reply.Number, 2u);
  EXPECT_EQ(reply.Status, -ECONNRESET);

  ASSERT_TRUE(this->Kernel.Unlink(3, 1));
  EXPECT_EQ(this->Kernel.Receive(false).Status, 0) << "it has been given back already";
  ASSERT_TRUE(this->Kernel.Out(4, 2, { 1 }));
  EXPECT_EQ(this->Kernel.Receive(false).Number, 4u);
  EXPECT_EQ(this->Kernel.Receive(true).Command, 0u) << "the kernel no longer waits for it";
}

TEST_F(UsbIpTest, GivesTransfersBackBeforeTheyCome)
{
  ASSERT_TRUE(this->Kernel.Unlink(9, 8));
  EXPECT_EQ(this->Kernel.Receive(false).Status, -ECONNRESET);
  ASSERT_TRUE(this->Kernel.Out(8, 2, { 1 }));
  EXPECT_EQ(this->Kernel.Receive(false).Command, 0u) << "the kernel does not know it any more";
  ASSERT_TRUE(this->Kernel.Out(10, 2, { 2 }));
  EXPECT_EQ(this->Kernel.Receive(false).Number, 10u);
  ASSERT_TRUE(this->Kernel.In(11, 1, 64));
  EXPECT_EQ(this->Kernel.Receive(true).Data, Bytes({ 2 }));
}

TEST_F(UsbIpTest, EndsWhereTheKernelMakesNoSense)
{
  EXPECT_FALSE(this->Kernel.Raw({ 7, 1, 0, 0, 0, 0, 0, 0, 0, 0 })) << "no command";
  EXPECT_FALSE(this->Kernel.In(1, 0, 1u << 20)) << "more than any transfer has";
  this->Kernel.HangUp();
  EXPECT_FALSE(this->Kernel.GetDevice().Receive());
}
} // namespace machinetest
