// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the device is lost when the computer was asleep, but not when the thread pauses
 * between reading the two clocks.
 */
#include "Devices/Common/HardwareExchange.h"

#include <gtest/gtest.h>

using namespace VolumeHaptics;

namespace
{
constexpr std::int64_t Second = 1000000000; // ns

std::int64_t Asleep = 0;
std::int64_t Late = 0; ///< ns, reduces the result of the next call

std::int64_t Tell()
{
  const std::int64_t seen = Asleep - Late;
  Late = 0;
  return seen;
}
} // namespace

TEST(ExchangeSleep, IsToldFromBeingHeldUp)
{
  Asleep = 100 * Second;
  HardwareExchange exchange(&Tell);
  Late = Second; // pauses in the first call, too
  exchange.Begin();
  exchange.SetCondition(DeviceStage::Ready, "");
  for (int round = 0; round < 3; ++round)
  {
    EXPECT_FALSE(exchange.HasSlept());
    Late = Second;
    EXPECT_FALSE(exchange.HasSlept());
  }
  EXPECT_EQ(exchange.GetCondition().Stage, DeviceStage::Ready);

  Asleep += Second;
  EXPECT_TRUE(exchange.HasSlept());
  EXPECT_EQ(exchange.GetCondition().Stage, DeviceStage::Lost);
  EXPECT_FALSE(exchange.HasSlept()) << "once";
}

TEST(ExchangeSleep, OfADeviceThatWasUnpluggedDoesNotConcernTheNewOne)
{
  HardwareExchange exchange(&Tell);
  exchange.Begin();
  exchange.SetCondition(DeviceStage::Lost, "was unplugged.");
  exchange.RequestHome();
  Asleep += Second;
  exchange.BeginAgain();
  EXPECT_FALSE(exchange.HasSlept());
  EXPECT_FALSE(exchange.DrainHomeRequest());
  EXPECT_EQ(exchange.GetCondition().Stage, DeviceStage::Homing);
}
