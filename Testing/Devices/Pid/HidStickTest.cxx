// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests reading the positions of sticks and wheels from reports. */

#include "Devices/Pid/HidStick.h"
#include "Rigs/DescriptorRig.h"

using namespace hardwaretest;

namespace
{
/// Descriptor of a stick. Report 1 contains ten buttons, padding, and X and Y from -32767 to 32767.
/// Report 2 contains vendor data.
const Bytes Stick{ 0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x85, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29,
  0x0A, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x0A, 0x81, 0x02, 0x95, 0x06, 0x81, 0x03, 0x05,
  0x01, 0x09, 0x30, 0x09, 0x31, 0x16, 0x01, 0x80, 0x26, 0xFF, 0x7F, 0x75, 0x10, 0x95, 0x02, 0x81,
  0x02, 0x85, 0x02, 0x06, 0x00, 0xFF, 0x09, 0x01, 0x95, 0x01, 0x81, 0x02, 0xC0 };

const char* Take(const HidStick& stick, const Bytes& bytes, HidStick::State& state)
{
  return stick.Decode(bytes.data(), bytes.size(), state);
}
} // namespace

TEST(HidStick, SaysWhereItIsAndWhatIsHeld)
{
  HidStick stick;
  std::string error;
  ASSERT_TRUE(stick.Map(Parsed(Stick), error)) << error;
  EXPECT_TRUE(stick.HasSecondAxis());
  HidStick::State state;
  // Buttons 1 and 10 are pressed. X is fully right, and Y is halfway (rounded to one count).
  EXPECT_EQ(Take(stick, { 0x01, 0x01, 0x02, 0xFF, 0x7F, 0x00, 0xC0 }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0x201U);
  EXPECT_EQ(state.Axes[0], 1.0);
  EXPECT_NEAR(state.Axes[1], -0.5, 1.0 / 32767.0);
  // -32768 is outside the range, and counts as fully left.
  EXPECT_EQ(Take(stick, { 0x01, 0x00, 0xFC, 0x00, 0x80, 0x00, 0x00 }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0U) << "padding is no button";
  EXPECT_EQ(state.Axes[0], -1.0);
  EXPECT_EQ(state.Axes[1], 0.0);
}

TEST(HidStick, WithOneAxisTheSecondOneSaysNothing)
{
  HidStick stick;
  std::string error;
  ASSERT_TRUE(stick.Map(Parsed(Stick), error)) << error;
  stick.UseOneAxis();
  EXPECT_FALSE(stick.HasSecondAxis());
  HidStick::State state;
  EXPECT_EQ(Take(stick, { 0x01, 0x00, 0x00, 0xFF, 0x7F, 0x00, 0xC0 }, state), nullptr);
  EXPECT_EQ(state.Axes[0], 1.0);
  EXPECT_EQ(state.Axes[1], 0.0);
}

TEST(HidStick, RefusesOtherLengthsWithAReason)
{
  HidStick stick;
  std::string error;
  ASSERT_TRUE(stick.Map(Parsed(Stick), error)) << error;
  for (std::size_t size = 0; size <= 64; ++size)
  {
    HidStick::State state;
    Bytes bytes(size, 0xFF);
    if (size > 0)
    {
      bytes[0] = 0x01;
    }
    const char* reason = Take(stick, bytes, state);
    EXPECT_EQ(reason == nullptr, size == 7) << size;
    EXPECT_EQ(state.Buttons != 0, size == 7) << size;
  }
  HidStick::State state;
  EXPECT_EQ(Take(stick, { 0x02, 0xFF, 0xFF }, state), nullptr);
  EXPECT_EQ(Take(stick, { 0x09, 0xFF }, state), nullptr) << "not its business";
  EXPECT_NE(Take(stick, { 0x02, 0xFF }, state), nullptr);
  EXPECT_EQ(state.Buttons, 0U);
}

TEST(HidStick, AWheelIsAnAxisAndAMouseIsNot)
{
  HidStick stick;
  std::string error;
  // Descriptor of a wheel: steering from 0 to 255, without report ids.
  ASSERT_TRUE(stick.Map(Parsed({ 0x05, 0x02, 0x09, 0xC8, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,
                          0x95, 0x01, 0x81, 0x02 }),
    error));
  EXPECT_FALSE(stick.HasSecondAxis());
  HidStick::State state;
  EXPECT_EQ(Take(stick, { 0x00 }, state), nullptr);
  EXPECT_EQ(state.Axes[0], -1.0);
  EXPECT_EQ(Take(stick, { 0xFF }, state), nullptr);
  EXPECT_EQ(state.Axes[0], 1.0);
  EXPECT_FALSE(stick.Map(
    Parsed({ 0x05, 0x01, 0x09, 0x30, 0x15, 0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x01, 0x81, 0x06 }),
    error));
  EXPECT_NE(error.find("neither an absolute X axis nor a steering wheel"), std::string::npos);
}
