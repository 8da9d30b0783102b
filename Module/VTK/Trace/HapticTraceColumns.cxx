// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/HapticTraceColumns.h"

#include "VTK/Tools/ToolArrays.h"
#include "VTK/Trace/RecordingNames.h"
#include "VTK/Trace/TraceArrayChoice.h"
#include "VTK/Trace/TraceRow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

constexpr ColumnType Float64 = ColumnType::Float64;
constexpr ColumnType UInt8 = ColumnType::UInt8;

} // namespace

std::size_t TraceColumn::GetWidth() const
{
  const std::size_t size = this->Type == ColumnType::UInt8 ? 1
    : this->Type == ColumnType::Int32                      ? 4
                                                           : 8;
  return size * static_cast<std::size_t>(this->Components);
}

// The two lists are never destroyed, because a device that is deleted at the exit of the process
// still writes its recording.

const std::vector<TraceColumn>& GetTraceColumns()
{
  static const auto* const columns = new std::vector<TraceColumn>{
    { "Time", " (s)", Float64, 1, offsetof(TraceRow, Time) },
    { "Tip", " (world)", Float64, 3, offsetof(TraceRow, Tip) },
    { "Force", " (N)", Float64, 3, offsetof(TraceRow, Force) },
    { "NormalForce", " (N)", Float64, 1, offsetof(TraceRow, NormalForce) },
    { "FrictionForce", " (N)", Float64, 1, offsetof(TraceRow, FrictionForce) },
    { "DragForce", " (N)", Float64, 1, offsetof(TraceRow, DragForce) },
    { "Normal", "", Float64, 3, offsetof(TraceRow, Normal) },
    { "Value", " (scalar)", Float64, 1, offsetof(TraceRow, Value) },
    { "GradientMagnitude", " (scalar/world)", Float64, 1, offsetof(TraceRow, GradientMagnitude) },
    { "SurfaceValue", " (scalar)", Float64, 1, offsetof(TraceRow, SurfaceValue) },
    { "MediumValue", " (scalar)", Float64, 1, offsetof(TraceRow, MediumValue) },
    { "Stiffness", " (N/m)", Float64, 1, offsetof(TraceRow, Stiffness) },
    { "Friction", "", Float64, 1, offsetof(TraceRow, Friction) },
    { "Viscosity", " (N)", Float64, 1, offsetof(TraceRow, Viscosity) },
    { "SurfaceStrength", " (N)", Float64, 1, offsetof(TraceRow, SurfaceStrength) },
    { "Contact", "", UInt8, 1, offsetof(TraceRow, Contact) },
    { "Unfinished", "", UInt8, 1, offsetof(TraceRow, Unfinished) },
    { RecordingNames::Renewed, "", UInt8, 1, offsetof(TraceRow, Renewed) },
    { "Energy", " (J)", Float64, 1, offsetof(TraceRow, Energy) },
  };
  return *columns;
}

const std::vector<TraceColumn>& GetRecordingColumns()
{
  static const auto* const columns = []
  {
    auto* const all = new std::vector<TraceColumn>{
      { RecordingNames::DeviceTip, " (m)", Float64, 3, offsetof(RecordingRow, DeviceTip) },
      { "Command", " (N)", Float64, 3, offsetof(RecordingRow, Command) },
      { "TorqueCommand", " (N m)", Float64, 3, offsetof(RecordingRow, TorqueCommand) },
      { RecordingNames::DeviceOrientation, "", Float64, 4,
        offsetof(RecordingRow, DeviceOrientation) },
      { RecordingNames::Orientation, "", Float64, 4, offsetof(RecordingRow, Orientation) },
      { "Tick", "", ColumnType::Int64, 1, offsetof(RecordingRow, Tick) },
      { RecordingNames::Enabled, "", UInt8, 1, offsetof(RecordingRow, Enabled) },
      { RecordingNames::Placement, "", ColumnType::Int32, 1, offsetof(RecordingRow, Placement) },
      { "Buttons", "", ColumnType::Int32, 1, offsetof(RecordingRow, Buttons) },
      { "Armed", "", UInt8, 1, offsetof(RecordingRow, Armed) },
      { "Fault", "", UInt8, 1, offsetof(RecordingRow, Fault) },
      { "Share", "", Float64, 1, offsetof(RecordingRow, Share) },
      { "Reason", "", UInt8, 1, offsetof(RecordingRow, Reason) },
      { RecordingNames::Spinning, "", UInt8, 1, offsetof(RecordingRow, Spinning) },
      { RecordingNames::RemovalRequest, "", UInt8, 1, offsetof(RecordingRow, RemovalRequest) },
    };
    const auto add = [all](TraceColumn column)
    {
      column.Offset += offsetof(RecordingRow, Trace);
      all->push_back(column);
    };
    for (const TraceColumn& column : GetTraceColumns())
    {
      add(column);
    }
    add({ DataTimeColumn, "", Float64, 1, offsetof(TraceRow, DataTime) });
    add({ "Torque", " (N m)", Float64, 3, offsetof(TraceRow, Torque) });
    std::size_t offset = offsetof(RecordingRow, OfTools);
    for (const ToolColumn* const array : GetToolArrays())
    {
      if (array->IsRecorded)
      {
        all->push_back({ array->Name, array->Unit, Float64, array->Components, offset });
        offset += static_cast<std::size_t>(array->Components) * sizeof(double);
      }
    }
    add({ "Proxy", " (world)", Float64, 3, offsetof(TraceRow, Proxy) });
    return all;
  }();
  return *columns;
}

std::string GetTraceUnit(const std::string& array)
{
  for (const TraceColumn& column : GetRecordingColumns())
  {
    if (column.Name == array)
    {
      return column.Unit;
    }
  }
  for (const ToolColumn* const column : GetToolArrays())
  {
    if (column->Name == array)
    {
      return column->Unit;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::vector<ContactRow> ToRows(const ShellContacts& contacts)
{
  std::vector<ContactRow> rows;
  rows.reserve(contacts.Count);
  for (std::size_t i = 0; i < contacts.Count; ++i)
  {
    const ShellContact& c = contacts.List[i];
    rows.push_back({ static_cast<double>(c.Point), c.Offset.X, c.Offset.Y, c.Offset.Z, c.Depth,
      c.Energy, c.Stretch, c.Stiffness, c.Strength, contacts.Fraction });
  }
  return rows;
}

bool FromRow(const ContactRow& row, ShellContact& contact, double& fraction)
{
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  const double point = row[0];
  const bool isPoint = point >= 0.0 && point <= most && point == std::floor(point);
  const bool areFinite =
    std::all_of(row.begin(), row.end(), [](double number) { return std::isfinite(number); });
  const bool areAmounts =
    std::all_of(row.begin() + 4, row.end(), [](double number) { return number >= 0.0; });
  contact = { { row[1], row[2], row[3] }, row[4], row[5], row[6], row[7], row[8],
    isPoint ? static_cast<std::uint32_t>(point) : 0 };
  fraction = row[9];
  return isPoint && areFinite && areAmounts && fraction <= 1.0;
}

} // namespace VolumeHaptics
