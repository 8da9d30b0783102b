// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Six-axis mice: their packets, and which devices are some.
 */

#include "Devices/SpaceMouse/SpaceMouse.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace
{
using Bytes = std::vector<std::uint8_t>;
using Axes = std::array<double, 6>;

const char* Take(const Bytes& bytes, SpaceMouse::State& state)
{
  return SpaceMouse::Decode(bytes.data(), bytes.size(), state);
}
} // namespace

TEST(SpaceMouse, OlderModelsSendPushesAndTurnsInTurn)
{
  SpaceMouse::State state;
  // 350, -350, 0; then 0, 0, -350; then the first and the fifteenth button.
  EXPECT_EQ(Take({ 0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x00, 0x00 }, state), nullptr);
  EXPECT_EQ(state.Axes, (Axes{ 1.0, -1.0, 0.0, 0.0, 0.0, 0.0 }));
  EXPECT_EQ(Take({ 0x02, 0x00, 0x00, 0x00, 0x00, 0xA2, 0xFE }, state), nullptr);
  EXPECT_EQ(state.Axes, (Axes{ 1.0, -1.0, 0.0, 0.0, 0.0, -1.0 }));
  EXPECT_EQ(Take({ 0x03, 0x01, 0x40 }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0x4001U);
  EXPECT_EQ(Take({ 0x03, 0x00, 0x00, 0x00, 0x80, 0xFF, 0xFF }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0x80000000U) << "the first 32";
  EXPECT_EQ(Take({ 0x03, 0x02 }, state), nullptr);
  EXPECT_EQ(state.Buttons, 2U);
}

TEST(SpaceMouse, NewerModelsSendSixAxesTogether)
{
  SpaceMouse::State state;
  EXPECT_EQ(
    Take({ 0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x00, 0x00, 0x5E, 0x01, 0x00, 0x00, 0xA2, 0xFE }, state),
    nullptr);
  EXPECT_EQ(state.Axes, (Axes{ 1.0, -1.0, 0.0, 1.0, 0.0, -1.0 }));
}

TEST(SpaceMouse, OtherLengthsAreRefusedWithAReason)
{
  for (const std::uint8_t id : { 1, 2, 3 })
  {
    for (std::size_t size = 0; size <= 64; ++size)
    {
      SpaceMouse::State state;
      Bytes bytes(size, 0x7F);
      if (size > 0)
      {
        bytes[0] = id;
      }
      const bool isWhole = id == 1 ? size == 7 || size == 13 : id == 2 ? size == 7 : size >= 2;
      const char* reason = Take(bytes, state);
      EXPECT_EQ(reason == nullptr, isWhole) << int{ id } << " " << size;
      if (!isWhole)
      {
        ASSERT_NE(reason, nullptr);
        EXPECT_FALSE(std::string(reason).empty());
        EXPECT_EQ(state.Axes, Axes{});
        EXPECT_EQ(state.Buttons, 0U);
      }
    }
  }
  SpaceMouse::State state;
  EXPECT_EQ(Take({ 0x17, 0x64, 0x00 }, state), nullptr) << "the battery";
  EXPECT_EQ(state.Axes, Axes{});
}

TEST(SpaceMouse, NothingJumpsAtTheDeadZone)
{
  EXPECT_EQ(SpaceMouse::Scale(0), 0.0);
  EXPECT_EQ(SpaceMouse::Scale(10), 0.0);
  EXPECT_EQ(SpaceMouse::Scale(-10), 0.0);
  EXPECT_NEAR(SpaceMouse::Scale(175), 0.47 / 0.97, 1e-12);
  EXPECT_EQ(SpaceMouse::Scale(32767), 1.0);
  EXPECT_EQ(SpaceMouse::Scale(-32768), -1.0);
  for (int counts = -400; counts < 400; ++counts)
  {
    const double step = SpaceMouse::Scale(counts + 1) - SpaceMouse::Scale(counts);
    EXPECT_GE(step, 0.0);
    EXPECT_LE(step, 1.0 / 350.0 / 0.97 + 1e-12);
    EXPECT_EQ(SpaceMouse::Scale(-counts), -SpaceMouse::Scale(counts));
  }
}

TEST(SpaceMouse, OnlyTheListCounts)
{
  for (const std::uint16_t product : { 0xC62E, 0xC632, 0xC633, 0xC638, 0xC63A, 0xC652 })
  {
    EXPECT_TRUE(SpaceMouse::IsKnown(0x256F, product));
    EXPECT_FALSE(SpaceMouse::IsKnown(0x046D, product));
  }
  EXPECT_TRUE(SpaceMouse::IsKnown(0x046D, 0xC626));
  EXPECT_FALSE(SpaceMouse::IsKnown(0x256F, 0xC626));
  // Numbers that neither list has.
  EXPECT_FALSE(SpaceMouse::IsKnown(0x256F, 0xC650));
  EXPECT_FALSE(SpaceMouse::IsKnown(0x256F, 0xC668));
  EXPECT_FALSE(SpaceMouse::IsKnown(0x046D, 0xC077));
}
