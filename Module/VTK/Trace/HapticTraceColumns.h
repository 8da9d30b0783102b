// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the arrays of traces and recordings with their names, types and units.
 *
 * The filter's output, the journal of a recording and both file formats are made from these lists.
 * Files store the contacts of a tool with a shape as plain numbers (ContactRow).
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

/** An array of a trace, and where its numbers are in a row. */
struct TraceColumn
{
  const char* Name;
  const char* Unit; ///< as in a column's title; empty without a unit
  ColumnType Type;
  int Components;
  std::size_t Offset; ///< offset in the row (bytes)

  /** Returns the size (bytes) of a tuple of the array. */
  std::size_t GetWidth() const;
};

/** Returns the columns of a TraceRow, except the proxy, which becomes the polydata's points. */
const std::vector<TraceColumn>& GetTraceColumns();
/** Returns the columns of a RecordingRow, with the proxy last. */
const std::vector<TraceColumn>& GetRecordingColumns();

/** Returns the unit of an array in a trace or recording, as in a title; empty without a unit. */
std::string GetTraceUnit(const std::string& array);

/**
 * The ten numbers of a contact: index of the point, offset (3, m), depth (m), energy (J), stretch
 * (m), stiffness (N/m^3), strength (N/m^2), and the fraction of the energy that counts, which is
 * the same for all contacts.
 */
using ContactRow = std::array<double, 10>;

std::vector<ContactRow> ToRows(const ShellContacts& contacts);
/**
 * Converts a row to a contact. Returns false for numbers that no tick produces, because a file may
 * contain any numbers.
 */
bool FromRow(const ContactRow& row, ShellContact& contact, double& fraction);

} // namespace VolumeHaptics

#endif
