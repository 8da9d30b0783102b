// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the status text reports how well the servo keeps time, and how a user can improve
 * this.
 */

#include "VTK/Device/DeviceStatus.h"

#include <gtest/gtest.h>

#include <string>

using namespace VolumeHaptics;

namespace
{
std::string TextOf(RealTimeGrant grant)
{
  const ServoSnapshot state;
  DeviceStatus status;
  status.IsOpen = true;
  status.State = &state;
  status.RealTimePriority = grant;
  return status.MakeText();
}

bool Has(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}
} // namespace

TEST(TimeKeepingText, NamesTheCureThatHelps)
{
  const std::string alone = TextOf(RealTimeGrant::NoService);
  EXPECT_TRUE(Has(alone, "install rtkit")) << alone;
  EXPECT_TRUE(Has(alone, "rtprio")) << alone;
  EXPECT_TRUE(Has(alone, "Documentation/devices.md")) << alone;
  const std::string refused = TextOf(RealTimeGrant::Refused);
  EXPECT_FALSE(Has(refused, "install")) << refused;
  EXPECT_TRUE(Has(refused, "log in")) << refused;
  EXPECT_TRUE(Has(refused, "rtprio")) << refused;
  EXPECT_TRUE(Has(refused, "Documentation/devices.md")) << refused;
}

TEST(TimeKeepingText, NamesNoCureWhereNoneIsNeeded)
{
  for (const RealTimeGrant grant : { RealTimeGrant::Kernel, RealTimeGrant::RealtimeKit })
  {
    const std::string text = TextOf(grant);
    EXPECT_TRUE(Has(text, "Real-time priority granted")) << text;
    EXPECT_FALSE(Has(text, "rtprio")) << text;
    EXPECT_EQ(Has(text, "RealtimeKit"), grant == RealTimeGrant::RealtimeKit) << text;
  }
  EXPECT_FALSE(Has(TextOf(RealTimeGrant::Asked), "rtprio")) << "it may still be granted";
}
