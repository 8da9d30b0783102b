// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that invalid descriptors are refused, and that the error contains the fault and the index
 * of its byte.
 */

#include "Rigs/DescriptorRig.h"

using namespace hardwaretest;

namespace
{
/// Returns a descriptor with `count` fields of `size` bits, logical values from 0 to 1, and the
/// usage X.
Bytes Fields(std::uint8_t size, std::uint16_t count, std::uint8_t flags = 0x02)
{
  return { 0x05, 0x01, 0x09, 0x30, 0x15, 0x00, 0x25, 0x01, 0x75, size, 0x96,
    static_cast<std::uint8_t>(count & 0xFF), static_cast<std::uint8_t>(count >> 8), 0x81, flags };
}
void ExpectError(const Bytes& bytes, std::size_t position, const std::string& what)
{
  const std::string error = ErrorOf(bytes);
  EXPECT_NE(error.find("byte " + std::to_string(position) + ": "), std::string::npos) << error;
  EXPECT_NE(error.find(what), std::string::npos) << error;
}
} // namespace

TEST(BadDescriptor, CutShort)
{
  ExpectError({ 0x05, 0x01, 0x26, 0xFF }, 2, "cut short: 3 bytes announced, 2 left");
  ExpectError({ 0x05, 0x01, 0x27, 0xFF, 0xFF, 0xFF }, 2, "cut short: 5 bytes");
  ExpectError({ 0xFE }, 0, "cut short");
  ExpectError({ 0xFE, 0x02, 0x00, 0x11 }, 0, "cut short: 5 bytes announced, 4 left");
}

TEST(BadDescriptor, UnpairedItems)
{
  ExpectError({ 0x05, 0x01, 0xB4 }, 2, "Pop without a Push");
  ExpectError({ 0xA4, 0xB4, 0xB4 }, 2, "Pop without a Push");
  ExpectError({ 0x05, 0x01, 0xC0 }, 2, "End Collection without a Collection");
  ExpectError({ 0xA1, 0x01, 0xC0, 0xC0 }, 3, "End Collection without a Collection");
  ExpectError({ 0xA1, 0x01, 0x05, 0x01 }, 4, "a Collection has no End Collection");
  ExpectError({ 0xA9, 0x00 }, 0, "delimiters");
  ExpectError({ 0xA9, 0x01, 0x81, 0x02 }, 2, "between delimiters");
  ExpectError({ 0x29, 0x05 }, 0, "a usage maximum without a usage minimum below it");
  ExpectError({ 0x19, 0x06, 0x29, 0x05 }, 2, "a usage maximum without");
}

TEST(BadDescriptor, SizesThatDoNotFit)
{
  ExpectError(Fields(0, 1), 13, "a report size of 0 bits; 1 to 256 are possible");
  ExpectError({ 0x05, 0x01, 0x76, 0x01, 0x01, 0x95, 0x01, 0x91, 0x02 }, 7, "257 bits");
  ExpectError({ 0x77, 0xFF, 0xFF, 0xFF, 0xFF, 0x95, 0x01, 0x91, 0x02 }, 7, "4294967295 bits");
  ExpectError(Fields(1, 65535), 13, "a report count of 65535 makes the report longer than 4096");
  ExpectError(Fields(1, 65535, 0x01), 13, "a report count of 65535");
  ExpectError(Fields(32, 65535), 13, "a report count of 65535");
  ExpectError(Fields(1, 4097), 13, "a report count of 4097 makes more than 4096 fields");
}

TEST(BadDescriptor, ReportsThatGrowWithoutEnd)
{
  Bytes bytes = Fields(32, 1000);
  EXPECT_EQ(Parsed(bytes).GetReportSize(HidReportKind::Input, 0), 4000U);
  ExpectError(bytes + Bytes{ 0x81, 0x01 }, 15, "longer than 4096 bytes");
}

TEST(BadDescriptor, NestedWithoutEnd)
{
  Bytes collections;
  Bytes pushes;
  Bytes usages;
  for (int i = 0; i < 1000; ++i)
  {
    collections = collections + Bytes{ 0xA1, 0x00 };
    pushes = pushes + Bytes{ 0xA4 };
    usages = usages + Bytes{ 0x09, 0x01, 0x09, 0x02 };
  }
  ExpectError(collections, 64, "collections are nested more than 32 deep");
  ExpectError(pushes, 32, "Push more than 32 deep");
  ExpectError(usages, 2048, "more than 1024 usages");
  ExpectError(Bytes(16385, 0x00), 0, "longer than 16384 bytes");
  EXPECT_TRUE(Parsed(Bytes(16384, 0x00)).GetFields().empty());
}

TEST(BadDescriptor, ReportIdsThatCannotBeTold)
{
  ExpectError({ 0x85, 0x00 }, 0, "a report id of 0");
  ExpectError({ 0x86, 0x00, 0x01 }, 0, "a report id of 256");
  ExpectError(Fields(1, 1) + Bytes{ 0x85, 0x01 }, 15, "a report id after reports that have none");
  ExpectError(
    Bytes{ 0xA4, 0x85, 0x01, 0xB4 } + Fields(1, 1), 17, "a report without an id where others");
}

TEST(BadDescriptor, ARangeThatIsTheWrongWayRound)
{
  ExpectError({ 0x09, 0x30, 0x15, 0x05, 0x25, 0x02, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02 }, 10,
    "the logical minimum 5 is above the maximum 2");
  EXPECT_TRUE(Parsed({}).GetFields().empty()) << "nothing is not wrong";
}
