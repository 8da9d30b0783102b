// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the lifetime of a device's thread: Open() starts it, and Close() or the device's destructor
 * ends it.
 */

#include "Devices/Common/HardwareDevice.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace VolumeHaptics;

namespace
{

/** Counts the calls of a driver. Must outlive the driver. */
struct Calls
{
  std::atomic<int> Connects{ 0 };
  std::atomic<int> Disconnects{ 0 };
  std::atomic<int> Ended{ 0 };
  bool CanConnect = true;
  bool Throws = false;
};

class CountingDriver : public HardwareDriver
{
public:
  explicit CountingDriver(Calls& calls)
    : Count(calls)
  {
  }
  std::string GetName() const override { return "counting"; }
  DeviceLimits GetLimits() const override { return {}; }
  bool Connect(std::string& error) override
  {
    ++this->Count.Connects;
    error = this->Count.CanConnect ? "" : "It is not plugged in.";
    return this->Count.CanConnect;
  }
  void Serve(HardwareExchange& exchange) override
  {
    if (this->Count.Throws)
    {
      throw std::runtime_error("the driver gave up");
    }
    exchange.SetCondition(DeviceStage::Ready, "");
    while (!exchange.MustStop())
    {
      exchange.Report({});
      std::this_thread::yield();
    }
    ++this->Count.Ended;
  }
  void Disconnect() noexcept override { ++this->Count.Disconnects; }

private:
  Calls& Count;
};

DeviceState ReadUntil(DeviceBackend& device, DeviceState wanted)
{
  DeviceSample sample;
  DeviceState state = DeviceState::Running;
  for (int i = 0; i < 10000 && (state = device.Read(1e-3, sample)) != wanted; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return state;
}

std::unique_ptr<HardwareDevice> MakeDevice(Calls& calls)
{
  return std::make_unique<HardwareDevice>(std::make_unique<CountingDriver>(calls));
}

} // namespace

TEST(DeviceThread, ServesFromOpenToCloseAndAgain)
{
  Calls calls;
  const auto device = MakeDevice(calls);
  std::string error;
  for (int times = 1; times <= 3; ++times)
  {
    ASSERT_TRUE(device->Open(error));
    EXPECT_EQ(ReadUntil(*device, DeviceState::Running), DeviceState::Running);
    EXPECT_EQ(calls.Disconnects, times - 1);
    device->Close();
    device->Close();
    EXPECT_EQ(calls.Ended, times);
    EXPECT_EQ(calls.Disconnects, times);
  }
}

TEST(DeviceThread, OpeningAnOpenOneClosesItFirst)
{
  Calls calls;
  std::string error;
  {
    const auto device = MakeDevice(calls);
    ASSERT_TRUE(device->Open(error));
    ASSERT_TRUE(device->Open(error));
    EXPECT_EQ(calls.Disconnects, 1);
  }
  EXPECT_EQ(calls.Disconnects, 2) << "and so does its end";
  EXPECT_EQ(calls.Ended, 2);
}

TEST(DeviceThread, WhatCannotBeHadIsSaidAndNotServed)
{
  Calls calls;
  calls.CanConnect = false;
  const auto device = MakeDevice(calls);
  std::string error;
  EXPECT_FALSE(device->Open(error));
  EXPECT_EQ(error, "It is not plugged in.");
  device->Close();
  EXPECT_EQ(calls.Disconnects, 0);
}

TEST(DeviceThread, ADriverThatGivesUpIsALoss)
{
  Calls calls;
  calls.Throws = true;
  const auto device = MakeDevice(calls);
  std::string error;
  ASSERT_TRUE(device->Open(error));
  EXPECT_EQ(ReadUntil(*device, DeviceState::Lost), DeviceState::Lost);
  EXPECT_STREQ(device->GetCondition().Text.data(), "the driver gave up");
}
