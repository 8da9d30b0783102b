// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the lists of the arrays of traces and recordings. No number of a row may be written twice
 * or be outside of its row, and units must match the quantities.
 */

#include "VTK/Trace/HapticTraceColumns.h"
#include "VTK/Trace/TraceRow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using VolumeHaptics::ColumnType;
using VolumeHaptics::ContactRow;
using VolumeHaptics::TraceColumn;

namespace
{

void ExpectApart(const std::vector<TraceColumn>& columns, std::size_t size)
{
  std::vector<std::pair<std::size_t, const TraceColumn*>> places;
  std::set<std::string> names;
  for (const TraceColumn& column : columns)
  {
    EXPECT_TRUE(names.insert(column.Name).second) << column.Name << " is there twice";
    places.emplace_back(column.Offset, &column);
  }
  std::sort(places.begin(), places.end());
  std::size_t end = 0;
  for (const auto& [offset, column] : places)
  {
    EXPECT_GE(offset, end) << column->Name << " begins in the array before";
    end = offset + column->GetWidth();
  }
  EXPECT_LE(end, size) << places.back().second->Name << " ends behind its row";
}

} // namespace

TEST(TraceColumns, LieApartInTheirRows)
{
  ExpectApart(VolumeHaptics::GetTraceColumns(), sizeof(VolumeHaptics::TraceRow));
  ExpectApart(VolumeHaptics::GetRecordingColumns(), sizeof(VolumeHaptics::RecordingRow));
}

/// Numbers and ticks must have 8 bytes, int32 4 bytes, and flags 1 byte (IEEE 754, ISO C++).
TEST(TraceColumns, AreAsWideAsTheirNumbers)
{
  EXPECT_EQ((TraceColumn{ "", "", ColumnType::Float64, 3, 0 }.GetWidth()), 24u);
  EXPECT_EQ((TraceColumn{ "", "", ColumnType::Int64, 1, 0 }.GetWidth()), 8u);
  EXPECT_EQ((TraceColumn{ "", "", ColumnType::Int32, 2, 0 }.GetWidth()), 8u);
  EXPECT_EQ((TraceColumn{ "", "", ColumnType::UInt8, 3, 0 }.GetWidth()), 3u);
}

/// A recording must have all arrays of a trace, so that both can be read in the same way. The proxy
/// is the last array.
TEST(TraceColumns, OfARecordingHoldThoseOfATrace)
{
  const std::vector<TraceColumn>& all = VolumeHaptics::GetRecordingColumns();
  for (const TraceColumn& column : VolumeHaptics::GetTraceColumns())
  {
    const auto found = std::find_if(all.begin(), all.end(),
      [&column](const TraceColumn& one) { return std::string(one.Name) == column.Name; });
    ASSERT_NE(found, all.end()) << column.Name;
    EXPECT_EQ(found->Offset, offsetof(VolumeHaptics::RecordingRow, Trace) + column.Offset);
    EXPECT_EQ(found->Type, column.Type) << column.Name;
    EXPECT_EQ(found->Components, column.Components) << column.Name;
  }
  EXPECT_EQ(all.back().Offset,
    offsetof(VolumeHaptics::RecordingRow, Trace) + offsetof(VolumeHaptics::TraceRow, Proxy));
}

/// Forces must be in N, spring constants in N/m, torques in N m, and work in J.
TEST(TraceColumns, HaveTheUnitsOfTheirQuantities)
{
  const std::map<std::string, std::string> units = { { "Time", " (s)" }, { "Tip", " (world)" },
    { "Proxy", " (world)" }, { "Force", " (N)" }, { "NormalForce", " (N)" },
    { "FrictionForce", " (N)" }, { "DragForce", " (N)" }, { "Normal", "" },
    { "GradientMagnitude", " (scalar/world)" }, { "Stiffness", " (N/m)" }, { "Friction", "" },
    { "Viscosity", " (N)" }, { "SurfaceStrength", " (N)" }, { "Energy", " (J)" },
    { "Torque", " (N m)" }, { "DeviceTip", " (m)" }, { "Command", " (N)" },
    { "TorqueCommand", " (N m)" }, { "Contact", "" }, { "Nobody", "" } };
  for (const auto& [name, unit] : units)
  {
    EXPECT_EQ(VolumeHaptics::GetTraceUnit(name), unit) << name;
  }
}

TEST(ContactRows, ComeBackAsTheyWere)
{
  VolumeHaptics::ShellContacts contacts(8);
  contacts.List[0] = { { 1e-3, -2e-3, 3e-3 }, 4e-4, 5e-5, 6e-6, 7e9, 8e4, 4294967295u };
  contacts.List[1] = { { 0.0, 0.0, 0.0 }, 0.0, 0.0, 0.0, 0.0, 0.0, 3 };
  contacts.Count = 2;
  contacts.Fraction = 0.75;
  const std::vector<ContactRow> rows = VolumeHaptics::ToRows(contacts);
  ASSERT_EQ(rows.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    VolumeHaptics::ShellContact contact;
    double fraction = 0.0;
    ASSERT_TRUE(VolumeHaptics::FromRow(rows[i], contact, fraction)) << i;
    EXPECT_EQ(fraction, 0.75);
    EXPECT_EQ(contact.Point, contacts.List[i].Point);
    EXPECT_EQ(contact.Offset.Y, contacts.List[i].Offset.Y);
    EXPECT_EQ(contact.Depth, contacts.List[i].Depth);
    EXPECT_EQ(contact.Energy, contacts.List[i].Energy);
    EXPECT_EQ(contact.Stretch, contacts.List[i].Stretch);
    EXPECT_EQ(contact.Stiffness, contacts.List[i].Stiffness);
    EXPECT_EQ(contact.Strength, contacts.List[i].Strength);
  }
}

/// A file may contain numbers that no tick computes, so each number must be checked.
TEST(ContactRows, RefuseWhatNoTickComputes)
{
  const ContactRow good{ 5.0, 1e-3, 2e-3, 3e-3, 4e-4, 5e-5, 6e-6, 7e9, 8e4, 1.0 };
  VolumeHaptics::ShellContact contact;
  double fraction = 0.0;
  ASSERT_TRUE(VolumeHaptics::FromRow(good, contact, fraction));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < good.size(); ++i)
  {
    for (const double bad : { nan, infinity, -infinity })
    {
      ContactRow row = good;
      row[i] = bad;
      EXPECT_FALSE(VolumeHaptics::FromRow(row, contact, fraction)) << i << " is " << bad;
    }
    ContactRow row = good;
    row[i] = -1e-9;
    const bool mayBeNegative = i >= 1 && i <= 3; // the three components of the offset
    EXPECT_EQ(VolumeHaptics::FromRow(row, contact, fraction), mayBeNegative) << i;
  }
  for (const double point : { 4294967296.0, 0.5, 1e300 })
  {
    ContactRow row = good;
    row[0] = point;
    EXPECT_FALSE(VolumeHaptics::FromRow(row, contact, fraction)) << point;
  }
  ContactRow row = good;
  row[9] = 1.0000001;
  EXPECT_FALSE(VolumeHaptics::FromRow(row, contact, fraction)) << "more than all of the energy";
}
