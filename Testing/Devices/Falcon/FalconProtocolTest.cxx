// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests each byte of run packets in both directions, and which bytes are not a packet. */

#include "Devices/Falcon/FalconProtocol.h"

#include <gtest/gtest.h>

#include <string>

using namespace VolumeHaptics;

namespace
{
std::string Text(const FalconPacket& packet)
{
  return { packet.begin(), packet.end() };
}

FalconFlaw Read(const std::string& bytes, FalconReport& report)
{
  return FalconDecode(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), report);
}

// A valid report. Byte 13 is 0x41 + 0x74: the centre button, and all encoders homed.
const std::string Good = "<JFKPEDCBAAAI\xB5"
                         "A>";
} // namespace

TEST(FalconProtocol, SendsOrders)
{
  FalconOrder order;
  EXPECT_EQ(Text(FalconEncode(order)), "<AAAAAAAAAAAAAA>");
  order.Motors = { -1447, 0, 1 };
  order.Lights = FalconHome;
  EXPECT_EQ(Text(FalconEncode(order)), "<JFKPAAAABAAABA>");
  order.Motors = { 4096, -4096, 0x1234 };
  order.Lights = FalconGreen | FalconBlue | FalconRed;
  EXPECT_EQ(Text(FalconEncode(order)), "<AAABAAAPEDCBOA>");
  order.Motors = { -1, 32767, -32768 };
  order.Lights = 0xF0; // only bits that are no lights
  EXPECT_EQ(Text(FalconEncode(order)), "<PPPPPPPHAAAIAA>");
}

TEST(FalconProtocol, EveryRunPacketKeepsTheZero)
{
  EXPECT_EQ(Text(FalconRunPacket({})), "<AAAAAAAAAAAABA>");
  EXPECT_EQ(Text(FalconRunPacket({ { -1447, 0, 1 }, FalconGreen })), "<JFKPAAAABAAADA>");
}

TEST(FalconProtocol, TakesReports)
{
  FalconReport report;
  ASSERT_EQ(Read(Good, report), FalconFlaw::None);
  EXPECT_EQ(report.Encoders, (FalconCounts{ -1447, 0x1234, -32768 }));
  EXPECT_EQ(report.Buttons, FalconCenter);
  EXPECT_EQ(report.Homed, FalconAllHomed);

  // 0x41 + 0x2B: the buttons plus, forward and minus, and the second encoder homed.
  ASSERT_EQ(Read("<AAAAAAAAAAAAlA>", report), FalconFlaw::None);
  EXPECT_EQ(report.Encoders, FalconCounts{});
  EXPECT_EQ(report.Buttons, FalconPlus | FalconForwardButton | FalconMinus);
  EXPECT_EQ(report.Homed, 0x02);
}

TEST(FalconProtocol, SaysWhatIsWrong)
{
  FalconReport report;
  report.Encoders = { 7, 8, 9 };
  const auto with = [](std::size_t place, unsigned char byte)
  {
    std::string bytes = Good;
    bytes[place] = static_cast<char>(byte);
    return bytes;
  };
  EXPECT_EQ(Read("", report), FalconFlaw::Length);
  EXPECT_EQ(Read(Good.substr(0, 15), report), FalconFlaw::Length);
  EXPECT_EQ(Read(Good + "A", report), FalconFlaw::Length);
  EXPECT_EQ(Read(with(0, '>'), report), FalconFlaw::Begin);
  EXPECT_EQ(Read(with(15, '<'), report), FalconFlaw::End);
  EXPECT_EQ(Read(with(13, 0x40), report), FalconFlaw::Bits);
  EXPECT_EQ(Read(with(13, 0xC1), report), FalconFlaw::Bits);
  for (std::size_t place = 1; place <= 12; ++place)
  {
    for (const unsigned char byte : { 0x00, 0x40, 0x51, 0xFF })
    {
      EXPECT_EQ(Read(with(place, byte), report), FalconFlaw::Nibble);
    }
  }
  EXPECT_EQ(report.Encoders, (FalconCounts{ 7, 8, 9 })) << "what is wrong is not taken";
  EXPECT_EQ(Read(with(13, 0xC0), report), FalconFlaw::None);
  EXPECT_EQ(Read(with(14, 0x00), report), FalconFlaw::None) << "nothing is known of byte 14";
}

TEST(FalconProtocol, EveryNumberSurvivesBothWays)
{
  for (int number = -32768; number <= 32767; ++number)
  {
    const auto n = static_cast<std::int16_t>(number);
    const auto bits = static_cast<std::uint8_t>(number & 0x0F);
    const FalconCounts numbers{ n, static_cast<std::int16_t>(~number), 1 };
    FalconReport report{ numbers, bits, static_cast<std::uint8_t>(bits & FalconAllHomed) };
    const FalconPacket in = FalconEncode(report);
    FalconReport reportAgain;
    ASSERT_EQ(FalconDecode(in.data(), in.size(), reportAgain), FalconFlaw::None);
    EXPECT_EQ(reportAgain.Encoders, numbers);
    EXPECT_EQ(reportAgain.Buttons, report.Buttons);
    EXPECT_EQ(reportAgain.Homed, report.Homed);

    const FalconPacket out = FalconEncode(FalconOrder{ numbers, bits });
    FalconOrder orderAgain;
    ASSERT_EQ(FalconDecode(out.data(), out.size(), orderAgain), FalconFlaw::None);
    EXPECT_EQ(orderAgain.Motors, numbers);
    EXPECT_EQ(orderAgain.Lights, bits);
  }
}
