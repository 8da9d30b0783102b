// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceRow.h"

#include "Core/Servo/ServoLoop.h"

namespace VolumeHaptics
{
namespace
{

void Copy(const Vector3& from, double to[3])
{
  to[0] = from.X;
  to[1] = from.Y;
  to[2] = from.Z;
}

void Copy(const Quaternion& from, double to[4])
{
  to[0] = from.W;
  to[1] = from.X;
  to[2] = from.Y;
  to[3] = from.Z;
}

} // namespace

std::int64_t GetTraceLabel(const HapticModel& model, const TickRecord& record)
{
  const std::int64_t label = model.LabelAtDevice(record.Proxy + model.KernelLength * record.Normal);
  return label == NoLabel ? 0 : label;
}

bool IsHeldAtForbidden(const HapticModel& model, const TickRecord& record)
{
  const ForbiddenZone* const zone = model.Baked->GetZone();
  if (!zone || !(record.NormalForce > 0.0))
  {
    return false;
  }
  const ForbiddenPlace place = zone->Find(model.DeviceToLabel(record.Proxy));
  return place.IsNear && place.Distance < zone->GetStandOff() + 2.0 * zone->GetTolerance();
}

void FillTraceRow(
  const HapticModel& model, double time, const TickRecord& record, WorkMeter& work, TraceRow& row)
{
  FillTraceRowWithoutValue(model, time, record, work, row);
  row.Value = model.ValueAtDevice(record.Proxy, record.DataTime);
}

void FillTraceRowWithoutValue(
  const HapticModel& model, double time, const TickRecord& record, WorkMeter& work, TraceRow& row)
{
  // Device axes are the world's, rotated: lengths are scaled, forces and directions are not.
  const Affine3& toWorld = model.DeviceToWorld;
  Copy(toWorld(record.Proxy), row.Proxy);
  row.Time = time;
  Copy(toWorld(record.Tip), row.Tip);
  Copy(model.DeviceToWorldRotation * record.Force, row.Force);
  row.NormalForce = record.NormalForce;
  row.FrictionForce = record.FrictionForce;
  row.DragForce = record.DragForce;
  Copy(model.DeviceToWorldRotation * record.Normal, row.Normal);
  row.Value = 0.0;
  row.GradientMagnitude = record.GradientMagnitude;
  row.SurfaceValue = record.SurfaceValue;
  row.MediumValue = record.MediumValue;
  row.Stiffness = record.Stiffness;
  row.Friction = record.Friction;
  row.Viscosity = record.Viscosity;
  row.SurfaceStrength = record.SurfaceStrength;
  row.Energy = work.Add(record);
  row.DataTime = model.Baked->IsMoving() ? record.DataTime : 0.0;
  row.Contact = static_cast<unsigned char>(record.Contact);
  row.Unfinished = record.IsUnfinished ? 1 : 0;
  row.Renewed = record.IsRenewed ? 1 : 0;
}

RecordingRow MakeRecordingRow(
  const HapticModel& model, const ServoSnapshot& snapshot, int placement, WorkMeter& work)
{
  RecordingRow row;
  FillTraceRow(model, snapshot.Time, snapshot.Record, work, row.Trace);
  Copy(snapshot.Record.Tip, row.DeviceTip);
  Copy(model.DeviceToWorldRotation * snapshot.Command, row.Command);
  Copy(model.DeviceToWorldRotation * snapshot.Torque, row.Torque);
  Copy(snapshot.HasOrientation ? snapshot.Orientation : NoOrientation, row.DeviceOrientation);
  Copy(TurnedBy(model.DeviceToWorldRotation, snapshot.Orientation, snapshot.HasOrientation),
    row.Orientation);
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
