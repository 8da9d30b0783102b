// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the arrays of traces and recordings with their names, types and units.
 *
 * The filter's output, the journal of a recording and both file formats are made from these lists.
 * Files hold contacts of a tool with a shape as plain numbers (ContactRow).
 */
#ifndef HapticTraceColumns_h
#define HapticTraceColumns_h

#include "Core/Tools/PointShell/ShellContacts.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

enum class ColumnType : std::uint8_t
{
  Float64,
  Int64,
  Int32,
  UInt8
};

/** An array, and the offset of its numbers in a row. */
struct TraceColumn
{
  const char* Name;
  const char* Unit; ///< unit as in a column's title; empty if there is none
  ColumnType Type;
  int Components;
  std::size_t Offset; ///< offset in the row (bytes)

  /** Returns the size of the array's tuple (bytes). */
  std::size_t GetWidth() const;
};

/** Lists the columns of a TraceRow, without the proxy, which becomes the polydata's points. */
const std::vector<TraceColumn>& GetTraceColumns();
/** Lists the columns of a RecordingRow; the proxy comes last. */
const std::vector<TraceColumn>& GetRecordingColumns();

/** Returns the unit of a trace's or a recording's array, as in a title; empty if it has none. */
std::string GetTraceUnit(const std::string& array);

/**
 * Ten numbers of a contact: the number of the point, the offset (3, m), depth (m), energy (J),
 * stretch (m), stiffness (N/m^3), strength (N/m^2), and the fraction of the energy that counts. All
 * contacts have the same fraction.
 */
using ContactRow = std::array<double, 10>;

std::vector<ContactRow> ToRows(const ShellContacts& contacts);
/**
 * Reads a row. Returns false for numbers that no tick produces, because a file may contain any
 * numbers.
 */
bool FromRow(const ContactRow& row, ShellContact& contact, double& fraction);

} // namespace VolumeHaptics

#endif
