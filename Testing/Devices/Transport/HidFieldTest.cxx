// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests writing values into reports and reading values from reports, bit by bit.
 */

#include "Devices/Transport/Hid/HidField.h"

#include <gtest/gtest.h>

#include <array>

using namespace VolumeHaptics;

namespace
{
HidField Field(std::uint32_t offset, std::uint8_t size, std::int64_t least, std::int64_t most)
{
  HidField field;
  field.BitOffset = offset;
  field.BitSize = size;
  field.LogicalMinimum = least;
  field.LogicalMaximum = most;
  field.IsSigned = least < 0;
  return field;
}
using Report = std::array<std::uint8_t, 6>;
} // namespace

TEST(HidField, IsReadAcrossBytesLowestBitFirst)
{
  const Report report{ 0x34, 0x12, 0xF8, 0xFF, 0x00, 0x80 };
  std::int64_t value = 0;
  EXPECT_TRUE(ReadValue(Field(0, 16, 0, 65535), report.data(), report.size(), value));
  EXPECT_EQ(value, 0x1234);
  EXPECT_TRUE(ReadValue(Field(4, 8, 0, 255), report.data(), report.size(), value));
  EXPECT_EQ(value, 0x23);
  EXPECT_TRUE(ReadValue(Field(16, 16, -32768, 32767), report.data(), report.size(), value));
  EXPECT_EQ(value, -8);
  EXPECT_TRUE(ReadValue(Field(19, 13, -4096, 4095), report.data(), report.size(), value));
  EXPECT_EQ(value, -1);
  EXPECT_TRUE(ReadValue(Field(16, 32, 0, 0xFFFFFFFF), report.data(), report.size(), value));
  EXPECT_EQ(value, 0x8000FFF8);
  EXPECT_TRUE(ReadValue(Field(47, 1, 0, 1), report.data(), report.size(), value));
  EXPECT_EQ(value, 1);
}

TEST(HidField, IsWrittenWithoutTouchingItsNeighbours)
{
  Report report{ 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00 };
  EXPECT_TRUE(WriteValue(Field(4, 12, -2048, 2047), report.data(), report.size(), -2048));
  EXPECT_EQ(report, (Report{ 0x0F, 0x80, 0xFF, 0x00, 0x00, 0x00 }));
  EXPECT_TRUE(WriteValue(Field(27, 9, 0, 511), report.data(), report.size(), 0x155));
  EXPECT_EQ(report, (Report{ 0x0F, 0x80, 0xFF, 0xA8, 0x0A, 0x00 }));
  EXPECT_TRUE(WriteValue(Field(16, 32, -2147483648LL, 2147483647), report.data(), 6, -2));
  EXPECT_EQ(report, (Report{ 0x0F, 0x80, 0xFE, 0xFF, 0xFF, 0xFF }));
}

TEST(HidField, ExcessIsClampedAndNeverTurnsTheSign)
{
  Report report{};
  std::int64_t value = 0;
  const HidField magnitude = Field(0, 16, -10000, 10000);
  EXPECT_TRUE(WriteValue(magnitude, report.data(), report.size(), 40000));
  EXPECT_EQ(report[0], 0x10);
  EXPECT_EQ(report[1], 0x27);
  EXPECT_TRUE(WriteValue(magnitude, report.data(), report.size(), -40000));
  EXPECT_TRUE(ReadValue(magnitude, report.data(), report.size(), value));
  EXPECT_EQ(value, -10000);
  // The logical range is wider than the field's 8 bits, so values are limited to the bits.
  const HidField narrow = Field(0, 8, -1000, 1000);
  EXPECT_TRUE(WriteValue(narrow, report.data(), report.size(), 200));
  EXPECT_EQ(report[0], 0x7F);
  EXPECT_TRUE(WriteValue(narrow, report.data(), report.size(), -200));
  EXPECT_EQ(report[0], 0x80);
  EXPECT_TRUE(WriteValue(Field(0, 8, 0, 1000), report.data(), report.size(), 300));
  EXPECT_EQ(report[0], 0xFF);
  EXPECT_TRUE(WriteValue(Field(0, 8, 1, 6), report.data(), report.size(), INT64_MIN));
  EXPECT_EQ(report[0], 0x01);
}

TEST(HidField, RawBitsGoBeyondTheLogicalRange)
{
  Report report{ 0xF7 };
  EXPECT_TRUE(WriteValue(Field(3, 1, 0, 0), report.data(), report.size(), 1));
  EXPECT_EQ(report[0], 0xF7);
  EXPECT_TRUE(WriteRaw(Field(3, 1, 0, 0), report.data(), report.size(), 1));
  EXPECT_EQ(report[0], 0xFF);
  EXPECT_TRUE(WriteRaw(Field(2, 2, 0, 0), report.data(), report.size(), 0x14));
  EXPECT_EQ(report[0], 0xF3);
  EXPECT_FALSE(WriteRaw(Field(41, 8, 0, 0), report.data(), report.size(), 1));
}

TEST(HidField, OutsideTheLogicalRangeThereIsNoValue)
{
  const Report report{ 0x00, 0x07 };
  std::int64_t value = 0;
  EXPECT_FALSE(ReadValue(Field(0, 8, 1, 6), report.data(), report.size(), value));
  EXPECT_FALSE(ReadValue(Field(8, 8, 1, 6), report.data(), report.size(), value));
  EXPECT_TRUE(ReadRaw(Field(8, 8, 1, 6), report.data(), report.size(), value));
  EXPECT_EQ(value, 7);
}

TEST(HidField, WhatIsTooShortIsNotTouched)
{
  Report report{};
  std::int64_t value = 5;
  const HidField field = Field(9, 16, 0, 65535);
  EXPECT_FALSE(ReadRaw(field, report.data(), 3, value));
  EXPECT_EQ(value, 0);
  EXPECT_FALSE(WriteValue(field, report.data(), 3, 65535));
  EXPECT_EQ(report, Report{});
  EXPECT_TRUE(WriteValue(field, report.data(), 4, 65535));
  EXPECT_FALSE(ReadRaw(field, nullptr, 0, value));
  EXPECT_FALSE(WriteValue(Field(0, 0, 0, 1), report.data(), 6, 1));
  EXPECT_FALSE(WriteValue(Field(0xFFFFFFFF, 32, 0, 1), report.data(), 6, 1));
}
