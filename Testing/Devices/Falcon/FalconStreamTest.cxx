// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests extracting reports from transfers: status bytes, split packets, and bytes between packets.
 */

#include "Devices/Falcon/FalconStream.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace
{
// A report with the encoders -1447, 0 and 1. Byte 13 is 0x41 + 0x71: the plus button, and all
// encoders homed.
const std::string Good = "<JFKPAAAABAAA\xB2"
                         "A>";
// A report with the encoders 2, 0 and 1.
const std::string Second = "<CAAAAAAABAAA\xB2"
                           "A>";

/** Returns bytes as a bulk IN transfer: two status bytes precede every 62 bytes. */
std::string Wrapped(const std::string& bytes)
{
  std::string transfer;
  for (std::size_t i = 0; i == 0 || i < bytes.size(); i += 62)
  {
    transfer += "\x01\x60" + bytes.substr(i, 62);
  }
  return transfer;
}

class FalconStreamed : public testing::Test
{
protected:
  int ReceiveTransfer(const std::string& transfer)
  {
    // Copy the bytes to a block of exactly this size, so that the address sanitizer detects a read
    // beyond the end.
    const std::vector<std::uint8_t> exact(transfer.begin(), transfer.end());
    return this->Stream.Receive(exact.data(), exact.size(), this->Report);
  }
  int Take(const std::string& bytes) { return this->ReceiveTransfer(Wrapped(bytes)); }

  FalconStream Stream;
  FalconReport Report;
};
} // namespace

TEST_F(FalconStreamed, OneReport)
{
  EXPECT_EQ(this->Take(Good), 1);
  EXPECT_EQ(this->Report.Encoders, (FalconCounts{ -1447, 0, 1 }));
  EXPECT_EQ(this->Report.Buttons, FalconPlus);
  EXPECT_EQ(this->Report.Homed, FalconAllHomed);
  EXPECT_EQ(this->Stream.GetDropped(), 0u);
}

TEST_F(FalconStreamed, NothingToSay)
{
  this->Report.Encoders = { 5, 5, 5 };
  for (const char* const transfer : { "", "\x01", "\x01\x60" })
  {
    EXPECT_EQ(this->ReceiveTransfer(transfer), 0);
  }
  EXPECT_EQ(this->Report.Encoders[0], 5);
  EXPECT_EQ(this->Take(Good), 1);
}

TEST_F(FalconStreamed, TheLastOfMany)
{
  // In these 80 bytes, the boundary between two USB packets is inside a report.
  EXPECT_EQ(this->Take(Good + Good + Good + Good + Second), 5);
  EXPECT_EQ(this->Report.Encoders[0], 2);
  EXPECT_EQ(this->Stream.GetDropped(), 0u);
}

TEST_F(FalconStreamed, SplitAnywhere)
{
  for (std::size_t first = 0; first <= 16; ++first)
  {
    for (std::size_t second = first; second <= 16; ++second)
    {
      const int reports = this->Take(Good.substr(0, first)) +
        this->Take(Good.substr(first, second - first)) + this->Take(Good.substr(second));
      EXPECT_EQ(reports, 1);
    }
  }
  EXPECT_EQ(this->Stream.GetDropped(), 0u);
}

TEST_F(FalconStreamed, GarbageBetween)
{
  EXPECT_EQ(this->Take("xyz" + Good + ">>" + Second), 2);
  EXPECT_EQ(this->Report.Encoders[0], 2);
  EXPECT_EQ(this->Stream.GetDropped(), 5u);
  EXPECT_EQ(this->Stream.GetFlaw(), FalconFlaw::Begin);
  this->Stream.Restart();
  EXPECT_EQ(this->Stream.GetDropped(), 0u);
  EXPECT_EQ(this->Stream.GetFlaw(), FalconFlaw::None);
}

TEST_F(FalconStreamed, ACutPacketNeverTakesTheNextWithIt)
{
  for (std::size_t length = 1; length < 16; ++length)
  {
    this->Stream.Restart();
    this->Report = {};
    EXPECT_EQ(this->Take(Good.substr(0, length) + Second), 1) << length;
    EXPECT_EQ(this->Report.Encoders[0], 2);
    EXPECT_EQ(this->Stream.GetDropped(), length);
    EXPECT_NE(this->Stream.GetFlaw(), FalconFlaw::None);
  }
}

TEST_F(FalconStreamed, ASpoiltByteCostsOnePacket)
{
  for (const std::size_t place : { 0, 1, 12, 13, 15 })
  {
    std::string spoilt = Good;
    spoilt[place] = 0x20;
    EXPECT_EQ(this->Take(spoilt + Second), 1) << place;
    EXPECT_EQ(this->Report.Encoders[0], 2);
  }
  EXPECT_EQ(this->Stream.GetDropped(), 5u * 16u);
}
