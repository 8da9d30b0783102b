// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests six-axis mice: their packets, and the USB devices that are recognised as such mice. */

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
  // Push the cap by 350, -350 and 0; then turn it by 0, 0 and -350; then press buttons 1 and 15.
  EXPECT_EQ(Take({ 0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x00, 0x00 }, state), nullptr);
  EXPECT_EQ(state.Axes, (Axes{ 1.0, -1.0, 0.0, 0.0, 0.0, 0.0 }));
  EXPECT_EQ(Take({ 0x02, 0x00, 0x00, 0x00, 0x00, 0xA2, 0xFE }, state), nullptr);
  EXPECT_EQ(state.Axes, (Axes{ 1.0, -1.0, 0.0, 0.0, 0.0, -1.0 }));
  EXPECT_EQ(Take({ 0x03, 0x01, 0x40 }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0x4001U);
  EXPECT_EQ(Take({ 0x03, 0x00, 0x00, 0x00, 0x80, 0x07, 0xFF }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0x80000000U) << "the first 32, and the Enterprise's";
  EXPECT_EQ(Take({ 0x03, 0x02 }, state), nullptr);
  EXPECT_EQ(state.Buttons, 2U);
}

TEST(SpaceMouse, EachKeyOfTheEnterpriseHasABitOfItsOwn)
{
  // Numbers of the keys: menu, fit, T, R, F, roll, isometric; 1 to 10; Esc, Alt, Shift, Ctrl, lock;
  // Enter, Delete; 11, 12; V1, V2, V3; Tab, Space.
  const int keys[] = { 1, 2, 3, 5, 6, 9, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
    27, 36, 37, 77, 78, 103, 104, 105, 175, 176 };
  std::uint32_t all = 0;
  for (const int key : keys)
  {
    SpaceMouse::State state;
    Bytes report(23, 0);
    report[0] = 3;
    report[1 + (key - 1) / 8] = static_cast<std::uint8_t>(1 << (key - 1) % 8);
    EXPECT_EQ(Take(report, state), nullptr);
    EXPECT_NE(state.Buttons, 0U) << key;
    EXPECT_EQ(state.Buttons & (state.Buttons - 1), 0U) << key;
    EXPECT_EQ(state.Buttons & all, 0U) << key;
    EXPECT_TRUE(key > 32 || state.Buttons == 1U << (key - 1)) << key;
    all |= state.Buttons;
  }
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
  for (const std::uint16_t product :
    { 0xC62E, 0xC62F, 0xC631, 0xC632, 0xC633, 0xC635, 0xC636, 0xC638, 0xC63A, 0xC652 })
  {
    EXPECT_TRUE(SpaceMouse::IsKnown(0x256F, product));
    EXPECT_FALSE(SpaceMouse::IsKnown(0x046D, product));
  }
  for (const std::uint16_t product : { 0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625, 0xC626,
         0xC627, 0xC628, 0xC629, 0xC62B, 0xC640 })
  {
    EXPECT_TRUE(SpaceMouse::IsKnown(0x046D, product));
    EXPECT_FALSE(SpaceMouse::IsKnown(0x256F, product));
    const bool isUp = product == 0xC603 || product == 0xC606 || product == 0xC640;
    EXPECT_EQ(SpaceMouse::HasAxisUp(0x046D, product), isUp);
  }
  // These numbers are in neither list.
  EXPECT_FALSE(SpaceMouse::IsKnown(0x256F, 0xC650));
  EXPECT_FALSE(SpaceMouse::IsKnown(0x256F, 0xC668));
  EXPECT_FALSE(SpaceMouse::IsKnown(0x046D, 0xC077));
}
