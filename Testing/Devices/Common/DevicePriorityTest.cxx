// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the thread of a device without privileges gets its priority from RealtimeKit, which
 * played_rtkit.py simulates.
 */

#include "Devices/Common/HardwareDevice.h"
#include "Rigs/Eventually.h"
#include "Rigs/PlayedRealtimeKit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

using namespace VolumeHaptics;
using namespace servotest;

namespace
{
class QuietDriver : public HardwareDriver
{
public:
  explicit QuietDriver(std::atomic<std::int64_t>& thread)
    : Thread(thread)
  {
  }
  std::string GetName() const override { return "quiet"; }
  DeviceLimits GetLimits() const override { return {}; }
  bool Connect(std::string&) override { return true; }
  void Serve(HardwareExchange& exchange) override
  {
    this->Thread = ThisThread();
    while (!exchange.MustStop())
    {
      std::this_thread::yield();
    }
  }
  void Disconnect() noexcept override {}

private:
  std::atomic<std::int64_t>& Thread;
};
} // namespace

TEST(DevicePriority, IsThatOfRealtimeKitWithoutPrivileges)
{
  PlayedBus bus;
  if (const char* const missing = bus.DetectMissing())
  {
    GTEST_SKIP() << missing;
  }
  PlayedRealtimeKit service;
  ASSERT_TRUE(AllowPriority(0));
  DropPrivileges();
  std::atomic<std::int64_t> thread{ 0 };
  HardwareDevice device(std::make_unique<QuietDriver>(thread));
  for (int i = 0; i < 2; ++i)
  {
    std::string error;
    thread = 0;
    ASSERT_TRUE(device.Open(error));
    ASSERT_TRUE(devicetest::Eventually([&] { return thread != 0; }));
    const std::string expected = "MakeThreadRealtime " + std::to_string(thread.load()) + " 20";
    service.ReadCall();
    service.ReadCall();
    EXPECT_EQ(service.ReadCall(), expected) << "also after it was opened again";
    EXPECT_EQ(service.ReadCall(), "granted");
    device.Close();
  }
}

TEST(DevicePriority, IsNotWaitedForByClose)
{
  PlayedBus bus;
  if (const char* const missing = bus.DetectMissing())
  {
    GTEST_SKIP() << missing;
  }
  PlayedRealtimeKit service({ "--silent", "Get" });
  ASSERT_TRUE(AllowPriority(0));
  DropPrivileges();
  std::atomic<std::int64_t> thread{ 0 };
  HardwareDevice device(std::make_unique<QuietDriver>(thread));
  std::string error;
  ASSERT_TRUE(device.Open(error));
  EXPECT_NE(service.ReadCall(), "");
  device.Close();
  EXPECT_TRUE(service.ReadCalls().empty()) << "without heed to the end it would ask on";
}
