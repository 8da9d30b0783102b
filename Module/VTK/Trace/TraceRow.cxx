// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceRow.h"

#include "Core/Servo/ServoLoop.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Tools/ToolArrays.h"

namespace VolumeHaptics
{
namespace
{

/** Visitor for VisitTraceSources() that fills a row. */
struct RowFiller
{
  const HapticModel& Model;
  const TickRecord& Record;
  TraceRow& Row;

  void Point(double (TraceRow::*to)[3], Vector3 TickRecord::*from) const
  {
    ToArray(this->Model.DeviceToWorld(this->Record.*from), this->Row.*to);
  }
  // Rotate forces and directions without scaling, because only lengths are scaled between device
  // and world.
  void Direction(double (TraceRow::*to)[3], Vector3 TickRecord::*from) const
  {
    ToArray(this->Model.DeviceToWorldRotation * (this->Record.*from), this->Row.*to);
  }
  void Number(double TraceRow::*to, double TickRecord::*from) const
  {
    this->Row.*to = this->Record.*from;
  }
  template <typename Member>
  void Byte(unsigned char TraceRow::*to, Member from) const
  {
    this->Row.*to = static_cast<unsigned char>(this->Record.*from);
  }
};

} // namespace

std::int64_t GetTraceLabel(const HapticModel& model, const TickRecord& record)
{
  const double reach = record.Depth > 0.0 ? 0.0 : model.KernelLengthAlong(record.Normal);
  const std::int64_t label = model.LabelAtDevice(record.Proxy + reach * record.Normal);
  return label == NoLabel ? 0 : label;
}

bool IsHeldAtForbidden(const HapticModel& model, const TickRecord& record)
{
  const ForbiddenZone* const zone = model.Baked->GetZone();
  if (!zone || !(record.NormalForce > 0.0))
  {
    return false;
  }
  const ForbiddenPlace place =
    model.Baked->Labels->ComputeForbidden(model.DeviceToLabel(record.Proxy));
  return place.IsNear && place.Distance < zone->GetStandOff() + 2.0 * zone->GetTolerance();
}

double GetTraceDataTime(const HapticModel& model, const TickRecord& record)
{
  return model.Baked->IsMoving() ? record.DataTime : 0.0;
}

double GetTraceValue(const HapticModel& model, const TickRecord& record)
{
  return model.Baked->Removal || model.Baked->Others
    ? record.Value
    : model.ValueAtDevice(record.Proxy, record.DataTime);
}

void FillTraceRow(
  const HapticModel& model, double time, const TickRecord& record, WorkMeter& work, TraceRow& row)
{
  VisitTraceSources(RowFiller{ model, record, row });
  row.Time = time;
  row.Value = GetTraceValue(model, record);
  row.Energy = work.Add(record);
  row.DataTime = GetTraceDataTime(model, record);
}

RecordingRow MakeRecordingRow(
  const HapticModel& model, const ServoSnapshot& snapshot, int placement, WorkMeter& work)
{
  RecordingRow row;
  FillTraceRow(model, snapshot.Time, snapshot.Record, work, row.Trace);
  ToArray(snapshot.Record.Tip, row.DeviceTip);
  ToArray(model.DeviceToWorldRotation * snapshot.Command, row.Command);
  ToArray(model.DeviceToWorldRotation * snapshot.Torque, row.TorqueCommand);
  ToArray(snapshot.HasOrientation ? snapshot.Orientation : NoOrientation, row.DeviceOrientation);
  ToArray(TurnedBy(model.DeviceToWorldRotation, snapshot.Orientation, snapshot.HasOrientation),
    row.Orientation);
  double* numbers = row.OfTools;
  for (const ToolColumn* const array : GetToolArrays())
  {
    if (array->IsRecorded)
    {
      array->Read(model, snapshot.Record, numbers);
      numbers += array->Components;
    }
  }
  row.Tick = static_cast<std::int64_t>(snapshot.Tick);
  row.Placement = placement;
  row.Buttons = static_cast<std::int32_t>(snapshot.Buttons);
  row.Enabled = snapshot.Before.Enabled ? 0 : 1;
  row.Armed = snapshot.IsArmed() ? 1 : 0;
  row.Fault = static_cast<unsigned char>(snapshot.GetFault());
  row.Share = snapshot.Share;
  row.Reason = static_cast<unsigned char>(snapshot.Reason);
  row.Spinning = snapshot.Before.IsSpinning ? 1 : 0;
  row.RemovalRequest = static_cast<unsigned char>(snapshot.Record.Request);
  return row;
}

} // namespace VolumeHaptics
