// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the exchange of forces between the servo and a device's thread: when forces are passed, and
 * that neither side waits.
 */

#include "ExchangeRig.h"
#include "Rigs/ThreadWatch.h"

#include <chrono>
#include <cmath>
#include <thread>

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"
#else
#include <poll.h>
#endif

using namespace hardwaretest;

using ExchangeForce = ExchangeTest;

namespace
{
constexpr int LongWait = 60000; // ms; longer than the time limit of any test

bool IsAwake(const HardwareExchange& exchange)
{
#if defined(_WIN32)
  const HANDLE wake = LongToHandle(exchange.GetWakeDescriptor());
  const bool is = WaitForSingleObject(wake, 0) == WAIT_OBJECT_0;
  return is && SetEvent(wake); // sets the event again, because the wait has reset it
#else
  pollfd wake{ exchange.GetWakeDescriptor(), POLLIN, 0 };
  return poll(&wake, 1, 0) == 1;
#endif
}
} // namespace

TEST_F(ExchangeForce, ForceIsZeroUnlessReadyGivenAndNotQuenched)
{
  const auto force = [this] { return this->Exchange.GetForce().X; };
  EXPECT_EQ(this->Exchange.Give({ 2.0, 0.0, 0.0 }), DeviceState::Running);
  EXPECT_EQ(force(), 0.0) << "not ready";
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  this->Take();
  this->Exchange.Give({ 2.0, 0.0, 0.0 });
  EXPECT_GT(force(), 0.0);
  this->Exchange.Quench();
  EXPECT_FALSE(this->Exchange.IsAtRest());
  EXPECT_EQ(force(), 0.0);
  EXPECT_FALSE(this->Exchange.IsAtRest()) << "it has been asked for, but may not have been sent";
  EXPECT_EQ(force(), 0.0);
  EXPECT_TRUE(this->Exchange.IsAtRest());
  this->Exchange.Give({ NAN, 0.0, 0.0 });
  EXPECT_EQ(force(), 0.0);
}

TEST_F(ExchangeForce, AForceThatIsNotRenewedFades)
{
  this->Exchange.SetCondition(DeviceStage::Ready, "");
  this->Take();
  this->Exchange.Give({ 2.0, 0.0, 0.0 });
  const double age = HardwareExchange::WatchdogTime + HardwareExchange::FadeTime;
  std::this_thread::sleep_for(std::chrono::duration<double>(age));
  EXPECT_EQ(this->Exchange.GetForce().X, 0.0);
}

TEST_F(ExchangeForce, TheDeviceIsWokenByForcesStopsAndRequests)
{
  EXPECT_FALSE(IsAwake(this->Exchange));
  const auto wakes = [this](auto&& action)
  {
    action();
    const bool is = IsAwake(this->Exchange);
    this->Exchange.ClearWake();
    return is && !IsAwake(this->Exchange);
  };
  EXPECT_TRUE(wakes([this] { this->Exchange.Give({}); }));
  EXPECT_TRUE(wakes([this] { this->Exchange.Quench(); }));
  EXPECT_TRUE(wakes([this] { this->Exchange.RequestHome(); }));
  EXPECT_TRUE(wakes([this] { this->Exchange.RequestStop(); }));
  this->Exchange.Give({});
  this->Exchange.WaitForWake(LongWait);
  EXPECT_FALSE(IsAwake(this->Exchange)) << "the wait clears it";
  EXPECT_TRUE(this->Exchange.MustStop());
}

TEST_F(ExchangeForce, TheServoNeitherLocksNorAllocates)
{
  servotest::WatchThisThread(true);
  for (int tick = 0; tick < 1000; ++tick)
  {
    const auto stage = static_cast<DeviceStage>(tick % 4);
    this->Exchange.SetCondition(stage, "as it is");
    this->Exchange.Report(this->Sample);
    this->Take();
    this->Exchange.Give({ 1.0, 2.0, 3.0 });
    this->Exchange.Quench();
  }
  servotest::WatchThisThread(false);
  EXPECT_EQ(servotest::GetWatched().Allocations, 0u);
  EXPECT_EQ(servotest::GetWatched().Locks, 0u);
}
