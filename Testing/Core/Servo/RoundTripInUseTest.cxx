// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the round trip in use grows at once, and shrinks only after a while and only while
 * no force acts.
 */

#include "Core/Servo/RoundTripInUse.h"

#include <gtest/gtest.h>

using VolumeHaptics::RoundTripInUse;

namespace
{
constexpr std::int64_t Second = 1000000000; // ns
}

TEST(RoundTripInUse, IsNotKnownAtFirst)
{
  RoundTripInUse trip;
  EXPECT_EQ(trip.Get(), 0.0);
  EXPECT_FALSE(trip.Update(0.0, Second, false));
  EXPECT_TRUE(trip.Update(1e-3, Second, true));
  EXPECT_EQ(trip.Get(), 1e-3);
  trip.Reset();
  EXPECT_EQ(trip.Get(), 0.0);
}

TEST(RoundTripInUse, GrowsAtOnceByMoreThanAFifth)
{
  RoundTripInUse trip;
  trip.Update(1e-3, Second, true);
  EXPECT_FALSE(trip.Update(1.19e-3, Second, true));
  EXPECT_TRUE(trip.Update(1.21e-3, Second, true));
  EXPECT_TRUE(trip.Update(8e-3, Second, true));
  EXPECT_EQ(trip.Get(), 8e-3);
}

TEST(RoundTripInUse, ShrinksAfterTwoSecondsWhileNothingIsFelt)
{
  RoundTripInUse trip;
  trip.Update(8e-3, Second, true);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_FALSE(trip.Update(1e-3, (1 + i) * Second, true)) << "in contact";
  }
  EXPECT_TRUE(trip.Update(1e-3, 101 * Second, false));
  EXPECT_EQ(trip.Get(), 1e-3);
  trip.Update(8e-3, 102 * Second, false);
  EXPECT_FALSE(trip.Update(1e-3, 103 * Second, false));
  EXPECT_FALSE(trip.Update(1e-3, 104 * Second, false));
  EXPECT_FALSE(trip.Update(7.9e-3, 104 * Second, false)) << "it was long again meanwhile";
  EXPECT_FALSE(trip.Update(1e-3, 105 * Second, false));
  EXPECT_FALSE(trip.Update(1e-3, 106 * Second, false));
  EXPECT_TRUE(trip.Update(1e-3, 107 * Second, false));
}
