// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the text protocol of hfab controllers, in the format of forsslund/hfabapi, hfab_protocol.h
 * and hfab_serial.cpp (commit cf00e97).
 */

#include "Devices/Hfab/HfabProtocol.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace
{
std::vector<HfabAnswer> Read(HfabReader& reader, const std::string& text)
{
  std::vector<HfabAnswer> answers;
  for (const char byte : text)
  {
    if (reader.Receive(byte))
    {
      answers.push_back(reader.Get());
    }
  }
  return answers;
}
} // namespace

TEST(HfabProtocol, AnswersAreReadOneByOne)
{
  HfabReader reader;
  const auto answers = Read(reader, "[3,12,-7700,6000,1,-2,1023,0]\n[1,0,0,0,0,0,0,7]\n");
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].Model, 3);
  EXPECT_EQ(answers[0].Counts, (std::array<int, 6>{ 12, -7700, 6000, 1, -2, 1023 }));
  EXPECT_EQ(answers[0].Error, 0);
  EXPECT_EQ(answers[1].Model, 1);
  EXPECT_EQ(answers[1].Error, HfabGimbalErrors);
  EXPECT_EQ(reader.GetBadLines(), 0);
}

TEST(HfabProtocol, WhatIsNoAnswerIsCountedAndSkipped)
{
  for (const char* const bad : { "[3,1,2,3,4,5,6]", "[3,1,2,3,4,5,6,7,8]", "[3,,2,3,4,5,6,0]",
         "[3,1,2,3,4,5,6,-]", "[3,1 ,2,3,4,5,6,0]", "[3,--1,2,3,4,5,6,0]", "[3,1,2,x,4,5,6,0]",
         "[3,1,2,3,4,5,6,0", "[3,9876543210,2,3,4,5,6,0]", "[]", "[3,1-,2,3,4,5,6,0]" })
  {
    HfabReader reader;
    EXPECT_TRUE(Read(reader, bad).empty()) << bad;
    const auto after = Read(reader, "[2,1,2,3,4,5,6,0]\n");
    ASSERT_EQ(after.size(), 1U) << bad;
    EXPECT_EQ(after[0].Model, 2) << bad;
    EXPECT_EQ(reader.GetBadLines(), 1) << bad;
  }
}

TEST(HfabProtocol, MessagesAreLinesOfSixteenBytesAtLeast)
{
  const HfabMessage zero = EncodeHfab({});
  EXPECT_EQ(
    std::string(zero.Bytes.data(), zero.Size), std::string("[0,0,0]\n") + std::string(8, 0));
  const HfabMessage largest = EncodeHfab({ -3000, 3000, -2147483647 });
  EXPECT_EQ(std::string(largest.Bytes.data(), largest.Size), "[-3000,3000,-2147483647]\n");
}
