// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the driver's thread while a device is unplugged: it searches for the device twice a second,
 * connects to no other device, and discards earlier requests.
 */

#include "Devices/Common/HardwareDevice.h"
#include "Rigs/Eventually.h"

#include <gtest/gtest.h>

#include <functional>

using namespace VolumeHaptics;
using devicetest::Eventually;

namespace
{

/** State that the test sets, and counts of the driver's calls. Must outlive the driver. */
struct Played
{
  std::atomic<bool> IsPluggedIn{ true };
  /// whether a search for the device lasts until a stop is requested
  std::atomic<bool> Waits{ false };
  std::atomic<int> Looks{ 0 };
  std::atomic<int> Homes{ 0 };
  std::atomic<int> Serves{ 0 };
  std::atomic<double> MostForce{ 4.0 };
  std::function<void()> AtLook = [] {};
  std::string Error;
};

/** A driver that is ready once it is homed. */
class PlayedDriver : public HardwareDriver
{
public:
  explicit PlayedDriver(Played& played)
    : All(played)
  {
  }
  std::string GetName() const override { return "played"; }
  DeviceLimits GetLimits() const override
  {
    DeviceLimits limits;
    limits.MaximumForce = this->All.MostForce;
    return limits;
  }
  std::string GetIdentity() const override { return "played:1"; }
  bool Connect(std::string&) override { return this->All.IsPluggedIn; }
  bool Reconnect(
    const std::string& identity, const std::function<bool()>& mustStop, std::string& error) override
  {
    EXPECT_EQ(identity, "played:1");
    ++this->All.Looks;
    while (this->All.Waits && !mustStop())
    {
      std::this_thread::yield();
    }
    this->All.AtLook();
    error = this->All.Error;
    return this->All.IsPluggedIn;
  }
  void Serve(HardwareExchange& exchange) override
  {
    ++this->All.Serves;
    while (!exchange.MustStop() && this->All.IsPluggedIn)
    {
      if (exchange.HasSlept())
      {
        continue;
      }
      if (exchange.DrainHomeRequest())
      {
        ++this->All.Homes;
        exchange.Report({});
        exchange.SetCondition(DeviceStage::Ready, "");
      }
      exchange.GetForce();
      exchange.WaitForWake(1);
    }
    if (!this->All.IsPluggedIn)
    {
      exchange.SetCondition(DeviceStage::Lost, "was unplugged.");
    }
  }
  void Disconnect() noexcept override {}

private:
  Played& All;
};

class DeviceReturn : public testing::Test
{
protected:
  void SetUp() override { ASSERT_TRUE(this->Device.Open(this->Error)) << this->Error; }
  bool IsAt(DeviceStage stage)
  {
    return Eventually([&] { return this->Device.GetCondition().Stage == stage; });
  }
  bool Says(const std::string& part)
  {
    return Eventually(
      [&] {
        return std::string(this->Device.GetCondition().Text.data()).find(part) != std::string::npos;
      });
  }
  void Unplug()
  {
    this->Rig.IsPluggedIn = false;
    ASSERT_TRUE(this->IsAt(DeviceStage::Lost));
  }
  bool LooksOnce()
  {
    const int before = this->Rig.Looks;
    return Eventually([&] { return this->Rig.Looks > before; });
  }

  Played Rig;
  HardwareDevice Device{ std::make_unique<PlayedDriver>(this->Rig) };
  std::string Error;
};

} // namespace

TEST_F(DeviceReturn, AHomingRequestFromBeforeDoesNotHomeTheNewDevice)
{
  this->Device.Home();
  ASSERT_TRUE(this->IsAt(DeviceStage::Ready));
  this->Rig.AtLook = [this] { this->Device.Home(); };
  ASSERT_NO_FATAL_FAILURE(this->Unplug());
  this->Rig.IsPluggedIn = true;
  ASSERT_TRUE(Eventually([&] { return this->Rig.Serves == 2; }));
  EXPECT_TRUE(this->IsAt(DeviceStage::Homing));
  DeviceSample sample;
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_EQ(this->Device.Read(1e-3, sample), DeviceState::NotReady);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(this->Rig.Homes, 1) << "only that of the device before";
  this->Device.Home();
  EXPECT_TRUE(this->IsAt(DeviceStage::Ready));
  EXPECT_EQ(this->Rig.Homes, 2);
}

TEST_F(DeviceReturn, ARequestIsRefusedWithTheCureWhileItIsGone)
{
  ASSERT_NO_FATAL_FAILURE(this->Unplug());
  this->Device.Home();
  EXPECT_TRUE(this->Says("played was unplugged. Plug it in again: it is opened by itself"));
  EXPECT_TRUE(this->IsAt(DeviceStage::Lost));
  this->Rig.Error = "it can't be had.";
  this->Device.Home();
  EXPECT_TRUE(this->Says("it can't be had."));
}

TEST_F(DeviceReturn, TheServoDoesNotWakeTheLooks)
{
  ASSERT_NO_FATAL_FAILURE(this->Unplug());
  ASSERT_TRUE(this->LooksOnce());
  const int before = this->Rig.Looks;
  const auto begin = std::chrono::steady_clock::now();
  while (this->Rig.Looks < before + 3)
  {
    this->Device.Write({ 1.0, 0.0, 0.0 });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // Three searches take at least two periods of 0.5 s; a slow machine takes longer.
  EXPECT_GT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(990));
}

TEST_F(DeviceReturn, OtherLimitsAreRefused)
{
  ASSERT_NO_FATAL_FAILURE(this->Unplug());
  this->Rig.MostForce = 8.0;
  EXPECT_EQ(this->Device.GetLimits().MaximumForce, 4.0) << "as it was opened";
  this->Rig.IsPluggedIn = true;
  this->Device.Home();
  EXPECT_TRUE(this->Says("played is back with other limits than before. Open() and Start() it."));
  EXPECT_EQ(this->Rig.Serves, 1);
  this->Rig.MostForce = 4.0;
  EXPECT_TRUE(this->IsAt(DeviceStage::Homing));
}

TEST_F(DeviceReturn, CloseEndsALookThatWaits)
{
  this->Rig.Waits = true;
  ASSERT_NO_FATAL_FAILURE(this->Unplug());
  ASSERT_TRUE(this->LooksOnce());
  this->Device.Close();
}
