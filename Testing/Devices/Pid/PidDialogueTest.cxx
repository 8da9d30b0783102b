// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the messages that make a force-feedback device ready, or report why it can't be used, and
 * renew its effects. The requirements of devices are known from Linux (torvalds/linux,
 * drivers/hid/usbhid/hid-pidff.c, commit 02b5a60). The pool is "sometimes messed up", up to twenty
 * times. If the first effect gets the second block, the first block is the device's centring
 * spring. Since 6.15, pidff_reset() stops all effects after the reset. A magnitude without a sign
 * gets the absolute value (pidff_set_signed()), and the direction encodes the sign.
 */

#include "Devices/Pid/PidDialogue.h"
#include "Rigs/PidRig.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace hardwaretest;

namespace
{
/// Answers a dialogue like a device that is busy for `polls` polls and then allocates the blocks 7,
/// 8 and so on. The first `emptyPools` pool reports are empty. Returns the reports that the
/// dialogue sends.
std::vector<Bytes> Talk(PidDialogue& dialogue, int polls, const Bytes& pool, std::uint8_t status,
  std::uint8_t block = 6, int emptyPools = 0)
{
  std::vector<Bytes> said;
  int left = polls;
  HidReport report;
  for (int step = 0; step < 400; ++step)
  {
    const PidStep next = dialogue.GetStep(report);
    if (next == PidStep::Ready || next == PidStep::Failed)
    {
      break;
    }
    said.push_back(Wire(report));
    if (next == PidStep::Send)
    {
      block += report.Bytes[0] == 0x18 ? 1 : 0;
      dialogue.Sent(true);
    }
    else if (report.Bytes[0] == 0x16)
    {
      const Bytes empty(pool.size(), 0);
      dialogue.Fetched(emptyPools-- > 0 ? empty.data() : pool.data(), pool.size());
    }
    else
    {
      const Bytes answer{ block, left > 0 ? std::uint8_t{ 0 } : status };
      left = left > 0 ? left - 1 : polls;
      dialogue.Fetched(answer.data(), answer.size());
    }
  }
  return said;
}
const Bytes Pool{ 0x00, 0x10, 0x0A };
} // namespace

TEST(PidDialogue, GoesThroughTheSequence)
{
  const PidDevice device = Mapped({});
  PidDialogue dialogue(device, {});
  const std::vector<Bytes> expected{ { 0x15, 0x04 }, { 0x15, 0x04 }, { 0x15, 0x03 }, { 0x15, 0x01 },
    { 0x16, 0x00, 0x00, 0x00 }, { 0x14, 0xFF }, { 0x18, 0x01, 0x00, 0x00 }, { 0x17, 0x00, 0x00 },
    { 0x17, 0x00, 0x00 }, { 0x11, 0x07, 0x01, 0x64, 0x00, 0xFF, 0x04, 0x40, 0x00 },
    { 0x12, 0x07, 0x00, 0x00 }, { 0x13, 0x07, 0x01, 0x01 }, { 0x18, 0x01, 0x00, 0x00 },
    { 0x17, 0x00, 0x00 }, { 0x17, 0x00, 0x00 },
    { 0x11, 0x08, 0x01, 0x64, 0x00, 0xFF, 0x04, 0x00, 0x00 }, { 0x12, 0x08, 0x00, 0x00 },
    { 0x13, 0x08, 0x01, 0x01 } };
  EXPECT_EQ(Talk(dialogue, 1, Pool, 0x01), expected);
  HidReport report;
  EXPECT_EQ(dialogue.GetStep(report), PidStep::Ready);
  EXPECT_EQ(dialogue.GetBlocks()[0], 7);
  EXPECT_EQ(dialogue.GetBlocks()[1], 8);
}

TEST(PidDialogue, ThePoolIsReadUntilItIsFilledIn)
{
  const PidDevice device = Mapped({});
  for (const int empty : { 1, 19, 30 })
  {
    PidDialogue dialogue(device, {});
    const std::vector<Bytes> said = Talk(dialogue, 0, Pool, 0x01, 6, empty);
    EXPECT_EQ(std::count(said.begin(), said.end(), Bytes{ 0x16, 0x00, 0x00, 0x00 }),
      std::min(empty + 1, 20));
    HidReport report;
    EXPECT_EQ(dialogue.GetStep(report), PidStep::Ready) << dialogue.GetError();
  }
}

TEST(PidDialogue, TheDevicesOwnSpringIsStopped)
{
  const PidDevice device = Mapped({});
  const auto stops = [&device](std::uint8_t blocksBefore)
  {
    PidDialogue dialogue(device, {});
    const std::vector<Bytes> said = Talk(dialogue, 0, Pool, 0x01, blocksBefore);
    return std::count(said.begin(), said.end(), Bytes{ 0x13, 0x01, 0x03, 0x01 });
  };
  EXPECT_EQ(stops(1), 1) << "blocks 2 and 3 are given: block 1 is the device's";
  EXPECT_EQ(stops(0), 0) << "blocks 1 and 2 are ours";
  EXPECT_EQ(stops(6), 0);
}

TEST(PidDialogue, SaysWhyItFails)
{
  const PidDevice device = Mapped({});
  const auto errorOf = [&device](int polls, const Bytes& pool, std::uint8_t status)
  {
    PidDialogue dialogue(device, {});
    Talk(dialogue, polls, pool, status);
    return dialogue.GetError();
  };
  EXPECT_EQ(errorOf(59, Pool, 0x01), "");
  EXPECT_NE(errorOf(60, Pool, 0x01).find("does not say"), std::string::npos);
  EXPECT_NE(errorOf(0, Pool, 0x02).find("no room"), std::string::npos);
  EXPECT_NE(errorOf(0, Pool, 0x03).find("can't make"), std::string::npos);
  EXPECT_NE(errorOf(0, { 0x00, 0x10, 0x01 }, 0x01).find("fewer effects"), std::string::npos);
  EXPECT_EQ(errorOf(0, {}, 0x01), "") << "a pool is not needed";
  PidDialogue dialogue(device, {});
  dialogue.Sent(false);
  HidReport report;
  EXPECT_EQ(dialogue.GetStep(report), PidStep::Failed);
  EXPECT_NE(dialogue.GetError().find("does not accept"), std::string::npos);
}

TEST(PidDialogue, LeavesOutWhatTheDeviceHasNot)
{
  for (const char* part : { "Pool", "Device Gain" })
  {
    Stick stick;
    stick.Without = part;
    const PidDevice device = Mapped(stick);
    PidDialogue dialogue(device, {});
    EXPECT_EQ(Talk(dialogue, 0, Pool, 0x01).size(), 15U) << part << dialogue.GetError();
  }
}

TEST(PidStream, WithoutASignTwoEffectsOfAnAxisPushInOppositeDirections)
{
  Stick stick;
  stick.HasSign = false;
  const PidDevice device = Mapped(stick);
  PidSettings settings;
  settings.NewtonsPerFullScale = { 4.0, -4.0 };
  PidDialogue dialogue(device, settings);
  const std::vector<Bytes> said = Talk(dialogue, 0, Pool, 0x01);
  // Collect the device's angle (0 to 255 in the report) and the magnitude of each block.
  std::map<int, double> angles;
  std::map<int, double> magnitudes;
  for (const Bytes& report : said)
  {
    if (report[0] == 0x11)
    {
      EXPECT_EQ(report[6], 0x04) << "by its direction";
      angles[report[1]] = std::acos(-1.0) / 180.0 * std::round(report[7] * 360.0 / 255.0);
    }
  }
  ASSERT_EQ(angles.size(), 4U);
  PidStream stream(device, settings, dialogue);
  HidReport report;
  for (const std::array<double, 2> force : std::vector<std::array<double, 2>>{
         { 1.0, 0.0 }, { -1.0, 2.0 }, { 0.0, -3.0 }, { 8.0, -8.0 }, { 0.0, 0.0 } })
  {
    for (int i = 0; i < 8 && stream.Next(0.001, force, report); ++i)
    {
      if (report.Bytes[0] == 0x12)
      {
        magnitudes[report.Bytes[1]] = report.Bytes[2] | report.Bytes[3] << 8;
      }
    }
    // Add the effects in polar coordinates: angles are clockwise from north.
    double x = 0.0;
    double y = 0.0;
    for (const auto& [block, magnitude] : magnitudes)
    {
      EXPECT_LE(magnitude, 10000.0);
      x += magnitude / 10000.0 * std::sin(angles[block]);
      y += magnitude / 10000.0 * std::cos(angles[block]);
    }
    EXPECT_NEAR(4.0 * x, std::clamp(force[0], -4.0, 4.0), 0.05);
    EXPECT_NEAR(-4.0 * y, std::clamp(force[1], -4.0, 4.0), 0.05);
  }
}

TEST(PidDialogue, WithoutASignThePoolNeedsTwoEffectsAnAxis)
{
  Stick stick;
  stick.HasSign = false;
  const PidDevice device = Mapped(stick);
  PidDialogue dialogue(device, {});
  Talk(dialogue, 0, { 0x00, 0x10, 0x03 }, 0x01);
  EXPECT_NE(dialogue.GetError().find("fewer effects"), std::string::npos);
}

TEST(PidStream, StartsAgainInTimeAndSendsOnlyWhatChanged)
{
  const PidDevice device = Mapped({});
  PidSettings settings;
  settings.NewtonsPerFullScale = { 4.0, -4.0 };
  settings.Duration = 5.0; // s; the driver must limit this to a safe 0.1 s
  PidDialogue dialogue(device, settings);
  EXPECT_EQ(Talk(dialogue, 0, Pool, 0x01)[8][3], 0x64);
  PidStream stream(device, settings, dialogue);
  HidReport report;
  EXPECT_FALSE(stream.Next(0.009, { 0.0, 0.0 }, report));
  EXPECT_TRUE(stream.Next(0.031, { 1.0, 1.0 }, report));
  EXPECT_EQ(Wire(report), (Bytes{ 0x12, 0x07, 0xC4, 0x09 }));
  EXPECT_TRUE(stream.Next(0.0, { 2.0, 1.0 }, report));
  EXPECT_EQ(Wire(report), (Bytes{ 0x12, 0x08, 0x3C, 0xF6 })) << "no axis waits for the other";
  EXPECT_TRUE(stream.Next(0.02, { 2.0, 1.0 }, report));
  EXPECT_EQ(Wire(report), (Bytes{ 0x13, 0x07, 0x01, 0x01 }));
  EXPECT_TRUE(stream.Next(0.0, { 2.0, 1.0 }, report));
  EXPECT_EQ(Wire(report), (Bytes{ 0x13, 0x08, 0x01, 0x01 }));
  EXPECT_TRUE(stream.Next(0.0, { 2.0, 1.0 }, report));
  EXPECT_EQ(Wire(report), (Bytes{ 0x12, 0x07, 0x88, 0x13 }));
  EXPECT_FALSE(stream.Next(0.0, { 2.0, 1.0 }, report));
}

TEST(PidStream, SendsSomethingEvery10MsByWhichTheDeviceShowsThatItIsAlive)
{
  const PidDevice device = Mapped({});
  PidDialogue dialogue(device, {});
  EXPECT_EQ(Talk(dialogue, 0, Pool, 0x01)[8][3], 0x64);
  PidStream stream(device, {}, dialogue);
  HidReport report;
  int silence = 0;
  for (int ms = 0; ms < 1000; ++ms)
  {
    silence = stream.Next(0.001, { 0.5, 0.5 }, report) ? 0 : silence + 1;
    EXPECT_LE(silence, 10) << ms;
  }
}
