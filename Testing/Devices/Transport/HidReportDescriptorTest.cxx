// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that report descriptors yield the correct positions of values in reports. */

#include "Rigs/DescriptorRig.h"

using namespace hardwaretest;

TEST(HidReportDescriptor, KnowsTheMouseOfTheSpecification)
{
  // The mouse in HID 1.11, appendix E.10, item by item.
  const HidReportDescriptor mouse = Parsed({ 0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1,
    0x00, 0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x03, 0x75, 0x01, 0x81,
    0x02, 0x95, 0x01, 0x75, 0x05, 0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15, 0x81, 0x25,
    0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0, 0xC0 });
  EXPECT_FALSE(mouse.UsesReportIds());
  EXPECT_EQ(mouse.GetReportSize(HidReportKind::Input, 0), 3U);
  EXPECT_EQ(mouse.GetReportSize(HidReportKind::Output, 0), 0U);
  const std::vector<HidField>& fields = mouse.GetFields();
  ASSERT_EQ(fields.size(), 5U);
  for (std::uint32_t b = 0; b < 3; ++b)
  {
    EXPECT_EQ(fields[b].Usage, 0x00090001U + b);
    EXPECT_EQ(fields[b].BitOffset, b);
    EXPECT_EQ(fields[b].BitSize, 1);
    EXPECT_FALSE(fields[b].IsArray || fields[b].IsRelative || fields[b].IsSigned);
  }
  for (std::uint32_t a = 0; a < 2; ++a)
  {
    const HidField& axis = fields[3 + a];
    EXPECT_EQ(axis.Usage, 0x00010030U + a);
    EXPECT_EQ(axis.BitOffset, 8 + 8 * a);
    EXPECT_EQ(axis.BitSize, 8);
    EXPECT_EQ(axis.LogicalMinimum, -127);
    EXPECT_EQ(axis.LogicalMaximum, 127);
    EXPECT_TRUE(axis.IsRelative && axis.IsSigned);
    EXPECT_TRUE(mouse.IsWithin(axis, 0x00010002)) << "a mouse";
    EXPECT_TRUE(mouse.IsWithin(axis, 0x00010001)) << "a pointer";
    EXPECT_FALSE(mouse.IsWithin(axis, 0x00010030));
  }
  ASSERT_EQ(mouse.GetCollections().size(), 2U);
  EXPECT_EQ(mouse.GetCollections()[1].Parent, 0);
}

TEST(HidReportDescriptor, PopBringsBackWhatWasPushed)
{
  // Items: a field of 8 bits from 0 to 100; push; a field of 16 bits from -300 to 300 in report 2;
  // pop.
  const HidReportDescriptor d = Parsed({ 0x05, 0x01, 0x85, 0x01, 0x15, 0x00, 0x25, 0x64, 0x75, 0x08,
    0x95, 0x01, 0xA4, 0x85, 0x02, 0x75, 0x10, 0x16, 0xD4, 0xFE, 0x26, 0x2C, 0x01, 0x09, 0x30, 0x91,
    0x02, 0xB4, 0x09, 0x31, 0xB1, 0x02 });
  ASSERT_EQ(d.GetFields().size(), 2U);
  const HidField& inner = d.GetFields()[0];
  const HidField& outer = d.GetFields()[1];
  EXPECT_TRUE(d.UsesReportIds());
  EXPECT_EQ(inner.Kind, HidReportKind::Output);
  EXPECT_EQ(inner.ReportId, 2);
  EXPECT_EQ(inner.LogicalMinimum, -300);
  EXPECT_EQ(inner.LogicalMaximum, 300);
  EXPECT_EQ(outer.Kind, HidReportKind::Feature);
  EXPECT_EQ(outer.ReportId, 1);
  EXPECT_EQ(outer.BitSize, 8);
  EXPECT_EQ(outer.LogicalMaximum, 100);
  EXPECT_EQ(d.GetReportSize(HidReportKind::Output, 2), 2U);
  EXPECT_EQ(d.GetReportSize(HidReportKind::Feature, 1), 1U);
}

TEST(HidReportDescriptor, FieldsOfMoreBitsThanANumberHasTakeUpTheirBits)
{
  // Two vendor fields of 64 bits, and then a field of 8 bits.
  const HidReportDescriptor d =
    Parsed({ 0x06, 0x00, 0xFF, 0x85, 0x01, 0x15, 0x00, 0x25, 0x04, 0x75, 0x40, 0x95, 0x02, 0x09,
      0x05, 0x09, 0x06, 0x91, 0x02, 0x75, 0x08, 0x95, 0x01, 0x09, 0x07, 0x91, 0x02 });
  ASSERT_EQ(d.GetFields().size(), 1U);
  EXPECT_EQ(d.GetFields()[0].Usage, MakeHidUsage(0xFF00, 7));
  EXPECT_EQ(d.GetFields()[0].BitOffset, 128U);
  EXPECT_EQ(d.GetReportSize(HidReportKind::Output, 1), 17U);
}

TEST(HidReportDescriptor, AMaximumIsSignedWhereTheMinimumIs)
{
  // A field of two bytes with logical values from 0 to 65535 and physical values from 0 to 255, in
  // units of 10^-3 seconds.
  const HidReportDescriptor d = Parsed({ 0x05, 0x0F, 0x09, 0x50, 0x15, 0x00, 0x26, 0xFF, 0xFF, 0x35,
    0x00, 0x45, 0xFF, 0x66, 0x01, 0x10, 0x55, 0xFD, 0x75, 0x10, 0x95, 0x01, 0x91, 0x02 });
  ASSERT_EQ(d.GetFields().size(), 1U);
  EXPECT_EQ(d.GetFields()[0].LogicalMaximum, 65535);
  EXPECT_EQ(d.GetFields()[0].PhysicalMaximum, 255);
  EXPECT_EQ(d.GetFields()[0].Unit, 0x1001U);
  EXPECT_EQ(d.GetFields()[0].UnitExponent, -3);
  EXPECT_FALSE(d.GetFields()[0].IsSigned);
}

TEST(HidReportDescriptor, UsagesTakeTheirPageAndTheLastOneRepeats)
{
  // Items: a 4-byte usage with its own page, a usage that precedes its page, and a fourth variable
  // without its own usage.
  const HidReportDescriptor d = Parsed({ 0x0B, 0x30, 0x00, 0x01, 0x00, 0x09, 0x70, 0x05, 0x0F, 0x09,
    0x22, 0x25, 0x7F, 0x75, 0x07, 0x95, 0x04, 0x81, 0x02 });
  ASSERT_EQ(d.GetFields().size(), 4U);
  EXPECT_EQ(d.GetFields()[0].Usage, 0x00010030U);
  EXPECT_EQ(d.GetFields()[1].Usage, 0x000F0070U);
  EXPECT_EQ(d.GetFields()[2].Usage, 0x000F0022U);
  EXPECT_EQ(d.GetFields()[3].Usage, 0x000F0022U);
  EXPECT_EQ(d.GetFields()[3].BitOffset, 21U);
  EXPECT_EQ(d.GetReportSize(HidReportKind::Input, 0), 4U) << "28 bits";
}

TEST(HidReportDescriptor, ArraysChooseByTheirPlaceInTheList)
{
  // The logical values 1 to 6 select the usages 97 to 9A and then 26. A long item follows, which is
  // ignored.
  const HidReportDescriptor d = Parsed({ 0x05, 0x0F, 0x19, 0x97, 0x29, 0x9A, 0x09, 0x26, 0x15, 0x01,
    0x25, 0x06, 0x75, 0x08, 0x95, 0x02, 0x91, 0x00, 0xFE, 0x02, 0xF0, 0xC0, 0xB4 });
  ASSERT_EQ(d.GetFields().size(), 2U);
  for (const HidField& field : d.GetFields())
  {
    std::int64_t value = 0;
    EXPECT_TRUE(field.IsArray);
    EXPECT_TRUE(d.ReadChoice(field, 0x000F009A, value));
    EXPECT_EQ(value, 4);
    EXPECT_TRUE(d.ReadChoice(field, 0x000F0026, value));
    EXPECT_EQ(value, 5);
    EXPECT_FALSE(d.ReadChoice(field, 0x000F009B, value));
  }
  EXPECT_EQ(d.GetFields()[1].BitOffset, 8U);
}

TEST(HidReportDescriptor, OfAlternativesTheFirstCounts)
{
  const HidReportDescriptor d = Parsed({ 0x05, 0x01, 0xA9, 0x01, 0x09, 0x30, 0x09, 0x31, 0xA9, 0x00,
    0x09, 0x32, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02 });
  ASSERT_EQ(d.GetFields().size(), 2U);
  EXPECT_EQ(d.GetFields()[0].Usage, 0x00010030U);
  EXPECT_EQ(d.GetFields()[1].Usage, 0x00010032U);
}
