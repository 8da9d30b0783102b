// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/HapticTraceColumns.h"

#include "VTK/Trace/HapticTipPath.h"

namespace VolumeHaptics
{
namespace
{

constexpr ColumnType Float64 = ColumnType::Float64;
constexpr ColumnType UInt8 = ColumnType::UInt8;

void Copy(const Vector3& from, double to[3])
{
  to[0] = from.X;
  to[1] = from.Y;
  to[2] = from.Z;
}

} // namespace

std::size_t TraceColumn::GetWidth() const
{
  const std::size_t size = this->Type == ColumnType::UInt8 ? 1
    : this->Type == ColumnType::Int32                      ? 4
                                                           : 8;
  return size * static_cast<std::size_t>(this->Components);
}

// Both lists are never destroyed: a device that is deleted while the process exits still writes its
// recording.

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
      { "Tick", "", ColumnType::Int64, 1, offsetof(RecordingRow, Tick) },
      { RecordingNames::Enabled, "", UInt8, 1, offsetof(RecordingRow, Enabled) },
      { RecordingNames::Placement, "", ColumnType::Int32, 1, offsetof(RecordingRow, Placement) },
      { "Buttons", "", ColumnType::Int32, 1, offsetof(RecordingRow, Buttons) },
      { "Armed", "", UInt8, 1, offsetof(RecordingRow, Armed) },
      { "Fault", "", UInt8, 1, offsetof(RecordingRow, Fault) },
      { "Share", "", Float64, 1, offsetof(RecordingRow, Share) },
      { "Reason", "", UInt8, 1, offsetof(RecordingRow, Reason) },
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
    add({ "Proxy", " (world)", Float64, 3, offsetof(TraceRow, Proxy) });
    return all;
  }();
  return *columns;
}

double WorkMeter::Add(const TickRecord& record)
{
  // A tip that is not finite does no work.
  if (this->HasLast && IsFinite(record.Tip) && IsFinite(this->LastTip))
  {
    this->Work += 0.5 * Dot(record.Force + this->LastForce, record.Tip - this->LastTip);
  }
  this->HasLast = true;
  this->LastTip = record.Tip;
  this->LastForce = record.Force;
  return this->Work;
}

TraceRow MakeTraceRow(
  const HapticModel& model, double time, const TickRecord& record, WorkMeter& work)
{
  // Device axes are the world's, rotated: lengths are scaled, forces and directions are not.
  const Affine3& toWorld = model.DeviceToWorld;
  TraceRow row;
  Copy(toWorld(record.Proxy), row.Proxy);
  row.Time = time;
  Copy(toWorld(record.Tip), row.Tip);
  Copy(model.DeviceToWorldRotation * record.Force, row.Force);
  row.NormalForce = record.NormalForce;
  row.FrictionForce = record.FrictionForce;
  row.DragForce = record.DragForce;
  Copy(model.DeviceToWorldRotation * record.Normal, row.Normal);
  row.Value = model.ValueAtDevice(record.Proxy);
  row.GradientMagnitude = record.GradientMagnitude;
  row.SurfaceValue = record.SurfaceValue;
  row.MediumValue = record.MediumValue;
  row.Stiffness = record.Stiffness;
  row.Friction = record.Friction;
  row.Viscosity = record.Viscosity;
  row.SurfaceStrength = record.SurfaceStrength;
  row.Energy = work.Add(record);
  row.Contact = static_cast<unsigned char>(record.Contact);
  row.Unfinished = record.IsUnfinished ? 1 : 0;
  row.Renewed = record.IsRenewed ? 1 : 0;
  return row;
}

RecordingRow MakeRecordingRow(
  const HapticModel& model, const ServoSnapshot& snapshot, int placement, WorkMeter& work)
{
  RecordingRow row;
  row.Trace = MakeTraceRow(model, snapshot.Time, snapshot.Record, work);
  Copy(snapshot.Record.Tip, row.DeviceTip);
  Copy(model.DeviceToWorldRotation * snapshot.Command, row.Command);
  row.Tick = static_cast<std::int64_t>(snapshot.Tick);
  row.Placement = placement;
  row.Buttons = static_cast<std::int32_t>(snapshot.Buttons);
  row.Enabled = snapshot.Before.Enabled ? 0 : 1;
  row.Armed = snapshot.IsArmed() ? 1 : 0;
  row.Fault = static_cast<unsigned char>(snapshot.GetFault());
  row.Share = snapshot.Share;
  row.Reason = static_cast<unsigned char>(snapshot.Reason);
  return row;
}

} // namespace VolumeHaptics
