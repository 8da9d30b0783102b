// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the parsing of Linux' descriptions of pads. The sysfs texts are those of the kernel's
 * drivers, taken from public bug reports: xpad's key=7cdb000000000000 0 0 0 0, ff=107030000 0.
 */

#include "Devices/Pad/EvdevReader.h"
#include "Devices/Transport/Evdev/EvdevNode.h"

#include <gtest/gtest.h>

#include <initializer_list>

using namespace VolumeHaptics;

namespace
{
input_absinfo Axis(int value, int least, int most)
{
  input_absinfo axis{};
  axis.value = value;
  axis.minimum = least;
  axis.maximum = most;
  return axis;
}

EvdevReader::News Take(EvdevReader& reader, unsigned type, unsigned code, int value)
{
  input_event event{};
  event.type = static_cast<__u16>(type);
  event.code = static_cast<__u16>(code);
  event.value = value;
  return reader.Receive(event);
}
} // namespace

TEST(EvdevReader, BitsOfSysfsAreFound)
{
  if (sizeof(long) != 8)
  {
    GTEST_SKIP() << "words of 64 bits";
  }
  const std::string keys = "7cdb000000000000 0 0 0 0\n";
  for (const unsigned code : { BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR, BTN_SELECT,
         BTN_START, BTN_MODE, BTN_THUMBL, BTN_THUMBR })
  {
    EXPECT_TRUE(HasEvdevBit(keys, code)) << std::hex << code;
  }
  for (const unsigned code : { BTN_C, BTN_Z, BTN_TL2, BTN_TR2, KEY_A, BTN_TOUCH })
  {
    EXPECT_FALSE(HasEvdevBit(keys, code)) << std::hex << code;
  }
  EXPECT_TRUE(HasEvdevBit("107030000 0", FF_RUMBLE));
  EXPECT_TRUE(HasEvdevBit("107030000 0", FF_GAIN));
  EXPECT_FALSE(HasEvdevBit("107030000 0", FF_CONSTANT));
  EXPECT_TRUE(HasEvdevBit("3003f", ABS_RZ));
  EXPECT_FALSE(HasEvdevBit("3003f", ABS_THROTTLE));
  for (const char* text : { "", "0", "\n", "x", "1x 0", "10000000000000000", "-1", "ff FF" })
  {
    EXPECT_FALSE(HasEvdevBit(text, ABS_X)) << text;
  }
}

TEST(EvdevReader, FollowsReports)
{
  EvdevReader reader;
  for (const unsigned code : { ABS_X, ABS_Y, ABS_RX, ABS_RY })
  {
    reader.SetAxis(code, Axis(0, -32768, 32767));
  }
  reader.SetAxis(ABS_Z, Axis(0, 0, 255));
  reader.SetAxis(ABS_RZ, Axis(0, 0, 255));
  EXPECT_EQ(reader.Get().LeftX, 0.0);
  EXPECT_EQ(Take(reader, EV_ABS, ABS_X, 32767), EvdevReader::News::None);
  Take(reader, EV_ABS, ABS_RY, -32768);
  Take(reader, EV_ABS, ABS_RZ, 255);
  Take(reader, EV_KEY, BTN_SOUTH, 1);
  Take(reader, EV_KEY, BTN_TR, 1);
  Take(reader, EV_ABS, ABS_MISC, 9); // an axis that the pad lacks
  EXPECT_EQ(Take(reader, EV_SYN, SYN_REPORT, 0), EvdevReader::News::Report);
  const PadState state = reader.Get();
  EXPECT_EQ(state.LeftX, 1.0);
  EXPECT_EQ(state.LeftY, 0.0);
  EXPECT_EQ(state.RightY, -1.0);
  EXPECT_EQ(state.RightTrigger, 1.0);
  EXPECT_EQ(state.LeftTrigger, 0.0);
  EXPECT_EQ(state.Buttons, PadSouth | PadRightShoulder);
  Take(reader, EV_KEY, BTN_TR, 0);
  EXPECT_EQ(reader.Get().Buttons, PadSouth);
}

TEST(EvdevReader, LostEventsAreAskedForAndRestsOfReportsDoNotCount)
{
  EvdevReader reader;
  reader.SetAxis(ABS_X, Axis(0, -100, 100));
  reader.SetAxis(ABS_Y, Axis(0, -100, 100));
  EXPECT_EQ(Take(reader, EV_SYN, SYN_DROPPED, 0), EvdevReader::News::None);
  EXPECT_EQ(Take(reader, EV_ABS, ABS_X, 100), EvdevReader::News::None);
  EXPECT_EQ(Take(reader, EV_SYN, SYN_REPORT, 0), EvdevReader::News::MustRead);
  EXPECT_EQ(reader.Get().LeftX, 0.0);
  EXPECT_EQ(Take(reader, EV_ABS, ABS_X, 100), EvdevReader::News::None);
  EXPECT_EQ(Take(reader, EV_SYN, SYN_REPORT, 0), EvdevReader::News::Report);
  EXPECT_EQ(reader.Get().LeftX, 1.0);
}

TEST(EvdevReader, ASecondStickAtZCountsIfItRestsInItsMiddle)
{
  EvdevReader stick;
  EvdevReader triggers;
  for (const unsigned code : { ABS_Z, ABS_RZ })
  {
    stick.SetAxis(code, Axis(128, 0, 255));
    triggers.SetAxis(code, Axis(0, 0, 255));
  }
  for (EvdevReader* const reader : { &stick, &triggers })
  {
    Take(*reader, EV_ABS, ABS_RZ, 255);
  }
  EXPECT_EQ(stick.Get().RightY, 1.0);
  EXPECT_EQ(stick.Get().RightTrigger, 0.0);
  EXPECT_EQ(triggers.Get().RightY, 0.0) << "else the tip would run away by itself";
  EXPECT_EQ(triggers.Get().RightTrigger, 1.0);
  stick.SetAxis(ABS_RZ, Axis(255, 0, 255));
  EXPECT_EQ(stick.Get().RightY, 1.0) << "it was in its middle at first";
}

TEST(EvdevReader, TriggersMayBeButtons)
{
  EvdevReader reader;
  Take(reader, EV_KEY, BTN_TL2, 1);
  EXPECT_EQ(reader.Get().LeftTrigger, 1.0);
  EXPECT_EQ(reader.Get().Buttons, 0U);
  reader.SetAxis(ABS_HAT2Y, Axis(0, 0, 255));
  EXPECT_EQ(reader.Get().LeftTrigger, 0.0) << "the axis says it finer";
}
