// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the transmitted bytes with bytes that were written by hand from the published protocol.
 */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
using Lines = std::vector<std::string>;

// A packet without a force. 0x42 is 0x41 plus the homing bit 0x01, which every packet has.
const std::string Zero = "o 3c 41 41 41 41 41 41 41 41 41 41 41 41 42 41 3e";
// A packet with the homing bit and the red light: 0x41 + 0x01 + 0x08.
const std::string Homing = "o 3c 41 41 41 41 41 41 41 41 41 41 41 41 4a 41 3e";

Lines Head(Lines lines, std::size_t count)
{
  lines.resize(std::min(lines.size(), count));
  return lines;
}

class FalconBytes : public FalconTest
{
};

class FalconBytesLoading : public FalconTest
{
protected:
  FalconBytesLoading()
    : FalconTest(false)
  {
  }
};
} // namespace

TEST_F(FalconBytes, TheFirstWords)
{
  ASSERT_TRUE(this->Open()) << this->Error;
  ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > 10; }));
  this->Device->Close();
  const Lines all = this->Falcon.DrainTranscript();
  // Expect a latency of 1 ms, the baud rate of run mode, a purge in both directions, then packets
  // with zero force.
  const Lines first = { "c 40 09 0001", "c 40 03 0002", "c 40 00 0001", "c 40 00 0002", Zero,
    Homing, Homing, Homing };
  EXPECT_EQ(Head(all, first.size()), first);
  EXPECT_EQ(all.back(), Zero) << "the last word";
}

TEST_F(FalconBytesLoading, TheLoadersDialogue)
{
  const TemporaryFile file(MakeImage(1100));
  this->Options.FirmwareFile = file.Path.string();
  ASSERT_TRUE(this->Open()) << this->Error;
  ASSERT_TRUE(Eventually([&] { return this->Falcon.GetPackets() > 2; })) << this->GetText();
  const Lines all = this->Falcon.DrainTranscript();
  // Skip the earlier packets, with which the driver checks whether the firmware runs.
  const auto begin = std::find(all.begin(), all.end(), "c 40 09 0010");
  ASSERT_NE(begin, all.end());
  ASSERT_GE(begin - all.begin(), 2);
  // Expect purge, latency 16, 9600 baud, 8N1, no flow control, RTS low, DTR low then high; the
  // greeting; DTR low, 140 kbaud, the handshake.
  const Lines expected = { "c 40 00 0001", "c 40 00 0002", "c 40 09 0010", "c 40 03 4138",
    "c 40 04 0008", "c 40 02 0000", "c 40 01 0200", "c 40 01 0100", "c 40 01 0101", "o 0a 43 0d",
    "c 40 01 0100", "c 40 03 0015", "o 41" };
  const Lines tail(begin - 2, all.end());
  EXPECT_EQ(Head(tail, expected.size()), expected);
  const Lines blocks(tail.begin() + 13, tail.begin() + 13 + 18);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    // Expect 17 blocks of 62 bytes, and a last block of 46 bytes.
    EXPECT_EQ(blocks[i].size(), 1 + 3 * (i < 17 ? 62u : 46u)) << i;
  }
  const Lines after(tail.begin() + 31, tail.end());
  const Lines run = { "c 40 09 0001", "c 40 03 0002", "c 40 00 0001", "c 40 00 0002" };
  EXPECT_EQ(Head(after, 4), run);
}

TEST_F(FalconBytes, Commands)
{
  this->MakeReady();
  this->Falcon.DrainTranscript();
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 1.0 }));
  ASSERT_TRUE(this->Push({}, [&] { return this->Falcon.GetCommands() == Numbers{}; }));
  // Near the centre, 1 N along z is an eighth of -2019 for each motor, so the motors get 0xFF04 to
  // 0xFF03, low nibble first. The light byte is blue: 0x41 + 0x04 + 0x01.
  const Lines all = this->Falcon.DrainTranscript();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
    [](const std::string& line) {
      return line.size() == 49 && line.substr(10, 6) == " 50 50" && line.substr(40, 3) == " 46";
    }));
  // Every packet must have the homing bit, without which the device would lose its zero.
  for (const std::string& line : all)
  {
    if (line.size() == 49)
    {
      EXPECT_EQ((std::stoi(line.substr(41, 2), nullptr, 16) - 0x41) & 0x01, 1) << line;
    }
  }
}
