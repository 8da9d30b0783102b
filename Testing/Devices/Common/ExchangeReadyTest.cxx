// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the servo sees a device as ready as soon as its condition is Ready. Otherwise, the
 * servo would undo an order to arm.
 */

#include "ExchangeRig.h"

#include <thread>

using namespace hardwaretest;

TEST_F(ExchangeTest, ACallerWhoReadsReadyCanArmIt)
{
  constexpr int rounds = 100000;
  std::atomic<int> begun{ 0 };
  std::atomic<int> ended{ 0 };
  const auto wait = [](auto&& holds)
  {
    while (!holds())
    {
      std::this_thread::yield();
    }
  };
  std::thread device(
    [&]
    {
      for (int i = 1; i <= rounds; ++i)
      {
        wait([&] { return begun == i; });
        this->Exchange.SetCondition(DeviceStage::Ready, "");
        ended = i;
      }
    });
  int refusals = 0;
  for (int i = 1; i <= rounds; ++i)
  {
    this->Exchange.SetCondition(DeviceStage::Homing, ""); // the device waits for homing
    this->Take();
    begun = i;
    wait([this] { return this->Exchange.GetCondition().Stage == DeviceStage::Ready; });
    refusals += this->Take() == DeviceState::NotReady ? 1 : 0;
    wait([&] { return ended == i; });
  }
  device.join();
  EXPECT_EQ(refusals, 0);
}
