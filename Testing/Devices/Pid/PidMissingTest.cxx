// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a device without the parts that constant forces need is refused, and that the error
 * names the missing parts.
 */

#include "Rigs/PidRig.h"

#include <algorithm>

using namespace hardwaretest;

namespace
{
std::string Refusal(const Bytes& bytes)
{
  PidDevice device;
  std::string error;
  EXPECT_FALSE(device.Map(Parsed(bytes), error));
  return error;
}
/// Returns the bytes with the first occurrence of `from` replaced by `to`.
Bytes Replace(Bytes bytes, const Bytes& from, const Bytes& to)
{
  const auto at = std::search(bytes.begin(), bytes.end(), from.begin(), from.end());
  EXPECT_NE(at, bytes.end());
  std::copy(to.begin(), to.end(), at);
  return bytes;
}
} // namespace

TEST(PidMissing, NamesEachReport)
{
  for (const char* part : { "Set Effect", "Set Constant Force", "Effect Operation",
         "Device Control", "Block Load", "Create New Effect" })
  {
    Stick stick;
    stick.Without = part;
    EXPECT_EQ(Refusal(Describe(stick)),
      std::string("No force feedback with this HID device; missing: ") + part);
  }
}

TEST(PidMissing, NamesEachField)
{
  const Bytes stick = Describe({});
  const auto missing = [&stick](const Bytes& from, const Bytes& to)
  {
    const std::string error = Refusal(Replace(stick, from, to));
    return error.substr(error.find("missing: ") + 9);
  };
  EXPECT_EQ(missing({ 0x09, 0x50 }, { 0x09, 0x51 }), "Duration in Set Effect");
  EXPECT_EQ(missing({ 0x09, 0x70 }, { 0x09, 0x71 }), "Magnitude in Set Constant Force");
  EXPECT_EQ(missing({ 0x09, 0x79 }, { 0x09, 0x7D }), "Effect Start in Effect Operation");
  EXPECT_EQ(missing({ 0x09, 0x9A }, { 0x09, 0x9F }), "Device Reset in Device Control");
  EXPECT_EQ(missing({ 0x09, 0x26 }, { 0x09, 0x28 }), "Constant Force in Set Effect");
  EXPECT_EQ(missing({ 0x09, 0x8C }, { 0x09, 0x8F }), "Block Load Success in Block Load");
  EXPECT_EQ(missing({ 0x16, 0xF0, 0xD8 }, { 0x16, 0x05, 0x00 }),
    "a Magnitude that can be below and above zero, or a direction");
}

TEST(PidMissing, NamesTheDirectionIfTheMagnitudeHasNoSign)
{
  Stick stick;
  stick.HasSign = false;
  const Bytes withIt = Describe(stick);
  PidDevice device;
  std::string error;
  EXPECT_TRUE(device.Map(Parsed(withIt), error)) << error;
  // Remove Direction Enable.
  EXPECT_EQ(Refusal(Replace(withIt, { 0x09, 0x56 }, { 0x09, 0x53 })),
    "No force feedback with this HID device; missing: a Magnitude that can be below and above "
    "zero, or a direction");
}

TEST(PidMissing, NamesEverythingForAMouse)
{
  const std::string error = Refusal({ 0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x30, 0x15, 0x81,
    0x25, 0x7F, 0x75, 0x08, 0x95, 0x01, 0x81, 0x06, 0xC0 });
  for (const char* part : { "Set Effect", "Set Constant Force", "Effect Operation",
         "Device Control", "Block Load", "Create New Effect" })
  {
    EXPECT_NE(error.find(part), std::string::npos) << error;
  }
}
