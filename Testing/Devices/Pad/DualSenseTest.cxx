// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the reports of a DualSense. Their layout follows the structures in Linux'
 * drivers/hid/hid-playstation.c. The check value of the CRC-32 follows from its definition (IEEE
 * 802.3).
 */

#include "Devices/Pad/DualSense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

using namespace VolumeHaptics;

namespace
{
using Bytes = std::vector<std::uint8_t>;
using Link = DualSense::Link;

const char* Take(const Bytes& bytes, Link& link, PadState& state)
{
  return DualSense::Decode(bytes.data(), bytes.size(), link, state);
}

/**
 * Returns a report as sent by cable, with these first bytes: x, y, rx, ry, l2, r2, a counter, three
 * bytes of buttons.
 */
Bytes MakeCableReport(const Bytes& first)
{
  Bytes report(64, 0);
  report[0] = 1;
  std::copy(first.begin(), first.end(), report.begin() + 1);
  return report;
}

std::uint32_t CrcOf(const Bytes& report)
{
  const std::uint8_t* const end = report.data() + report.size() - 4;
  return end[0] | end[1] << 8 | end[2] << 16 | std::uint32_t{ end[3] } << 24;
}
} // namespace

TEST(DualSense, TheChecksumHasItsCheckValue)
{
  const Bytes rest{ '2', '3', '4', '5', '6', '7', '8', '9' };
  EXPECT_EQ(DualSense::ComputeCrc('1', rest.data(), rest.size()), 0xCBF43926U);
}

TEST(DualSense, ByCableSticksAndButtonsAreRead)
{
  Link link = Link::Unknown;
  PadState state;
  EXPECT_EQ(
    Take(MakeCableReport({ 255, 0, 128, 255, 0, 255, 9, 0x28, 0x02, 0x01 }), link, state), nullptr);
  EXPECT_EQ(link, Link::Cable);
  EXPECT_EQ(state.LeftX, 1.0);
  EXPECT_EQ(state.LeftY, -1.0);
  EXPECT_EQ(state.RightX, 0.0);
  EXPECT_EQ(state.RightY, 1.0);
  EXPECT_EQ(state.LeftTrigger, 0.0);
  EXPECT_EQ(state.RightTrigger, 1.0);
  // The buttons are cross, R1 and PS. The value 8 means that the direction pad is released.
  EXPECT_EQ(state.Buttons, PadSouth | PadRightShoulder | PadMode);
  const std::pair<Bytes, std::uint32_t> buttons[] = { { { 0x10, 0, 0 }, PadWest },
    { { 0x40, 0, 0 }, PadEast }, { { 0x80, 0, 0 }, PadNorth }, { { 0, 0x01, 0 }, PadLeftShoulder },
    { { 0, 0x10, 0 }, PadSelect }, { { 0, 0x20, 0 }, PadStart }, { { 0, 0x40, 0 }, PadLeftStick },
    { { 0, 0x80, 0 }, PadRightStick }, { { 0x0F, 0x0C, 0xFE }, 0 } };
  for (const auto& [bytes, button] : buttons)
  {
    Take(
      MakeCableReport({ 128, 128, 128, 128, 0, 0, 0, bytes[0], bytes[1], bytes[2] }), link, state);
    EXPECT_EQ(state.Buttons, button);
  }
}

TEST(DualSense, ByRadioTheChecksumCounts)
{
  Bytes report(78, 0);
  report[0] = 0x31;
  std::fill_n(report.begin() + 2, 4, std::uint8_t{ 128 });
  report[2] = 255;
  const std::uint32_t crc = DualSense::ComputeCrc(0xA1, report.data(), 74);
  for (std::size_t i = 0; i < 4; ++i)
  {
    report[74 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
  }
  Link link = Link::Unknown;
  PadState state;
  EXPECT_EQ(Take(report, link, state), nullptr);
  EXPECT_EQ(link, Link::Bluetooth);
  EXPECT_EQ(state.LeftX, 1.0);
  for (std::size_t i = 1; i < report.size(); ++i)
  {
    Bytes spoilt = report;
    spoilt[i] ^= 0x10;
    PadState other;
    EXPECT_NE(Take(spoilt, link, other), nullptr) << i;
    EXPECT_EQ(other.LeftX, 0.0);
  }
  report.pop_back();
  EXPECT_NE(Take(report, link, state), nullptr);
}

TEST(DualSense, OtherReportsChangeNothing)
{
  for (std::size_t size = 0; size <= 100; ++size)
  {
    for (const std::uint8_t id : { 0, 1, 2, 5 })
    {
      Bytes report(size, 0xFF);
      if (size > 0)
      {
        report[0] = id;
      }
      Link link = Link::Unknown;
      PadState state;
      EXPECT_EQ(Take(report, link, state), nullptr);
      EXPECT_EQ(link == Link::Cable, id == 1 && size == 64) << size;
    }
  }
}

TEST(DualSense, ReportsToItHaveTheKernelsLayout)
{
  DualSense::Report report = DualSense::Encode(Link::Cable, false, 200, 100, 7);
  Bytes bytes(report.Bytes.begin(), report.Bytes.begin() + static_cast<long>(report.Size));
  Bytes expected(63, 0);
  expected[0] = 0x02; // report id
  expected[1] = 0x03; // valid_flag0: compatible vibration, haptics select
  expected[3] = 100;  // motor_right
  expected[4] = 200;  // motor_left
  EXPECT_EQ(bytes, expected);

  report = DualSense::Encode(Link::Cable, true, 1, 300, 7);
  bytes.assign(report.Bytes.begin(), report.Bytes.begin() + static_cast<long>(report.Size));
  expected[1] = 0x02; // haptics select
  expected[3] = 255;  // limited to a byte
  expected[4] = 1;
  expected[1 + 38] = 0x04; // valid_flag2: compatible vibration in the newer way
  EXPECT_EQ(bytes, expected);

  report = DualSense::Encode(Link::Bluetooth, true, 1, -5, 0x1B);
  bytes.assign(report.Bytes.begin(), report.Bytes.begin() + static_cast<long>(report.Size));
  expected.assign(78, 0);
  expected[0] = 0x31;
  expected[1] = 0xB0; // sequence number, modulo 16
  expected[2] = 0x10; // tag
  expected[3] = 0x02;
  expected[6] = 1;
  expected[3 + 38] = 0x04;
  ASSERT_EQ(bytes.size(), 78U);
  EXPECT_EQ(CrcOf(bytes), DualSense::ComputeCrc(0xA2, bytes.data(), 74));
  std::copy_n(bytes.begin() + 74, 4, expected.begin() + 74);
  EXPECT_EQ(bytes, expected);
  EXPECT_EQ(DualSense::Encode(Link::Unknown, true, 9, 9, 0).Size, 0U) << "nothing is guessed";
}

TEST(DualSense, TheFirmwareTellsTheWayOfVibration)
{
  Bytes firmware(64, 0);
  firmware[0] = 0x20;
  const auto isNewer = [&](std::uint16_t product, int version)
  {
    firmware[44] = static_cast<std::uint8_t>(version & 0xFF);
    firmware[45] = static_cast<std::uint8_t>(version >> 8);
    return DualSense::HasNewerVibration(product, firmware.data(), firmware.size());
  };
  EXPECT_FALSE(isNewer(0x0CE6, 0x0214));
  EXPECT_TRUE(isNewer(0x0CE6, 0x0215));
  EXPECT_TRUE(isNewer(0x0CE6, 0x0300));
  EXPECT_TRUE(isNewer(0x0DF2, 0)) << "an Edge";
  EXPECT_FALSE(DualSense::HasNewerVibration(0x0CE6, firmware.data(), 45)) << "a short answer";
  EXPECT_TRUE(DualSense::IsKnown(0x054C, 0x0CE6));
  EXPECT_TRUE(DualSense::IsKnown(0x054C, 0x0DF2));
  EXPECT_FALSE(DualSense::IsKnown(0x054C, 0x09CC)) << "a DualShock 4 has other reports";
  EXPECT_FALSE(DualSense::IsKnown(0x045E, 0x0CE6));
}
