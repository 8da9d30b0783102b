// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The values of a tick in a trace and in a recording; HapticTraceColumns.h lists them as arrays.
 */
#ifndef TraceRow_h
#define TraceRow_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"
#include "Core/State/TickRecord.h"

#include <cmath>
#include <cstdint>

namespace VolumeHaptics
{

class HapticModel;
struct ServoSnapshot;

/** A tick of a trace, in world space. */
struct TraceRow
{
  double Proxy[3];
  double Time; ///< s
  double Tip[3];
  double Force[3]; ///< N, like the other forces
  double NormalForce;
  double FrictionForce;
  double DragForce;
  double Normal[3];
  double Value;
  double GradientMagnitude;
  double SurfaceValue;
  double MediumValue;
  double Stiffness;
  double Friction;
  double Viscosity;
  double SurfaceStrength;
  double Energy; ///< J
  double DataTime;
  double Torque[3]; ///< torque of a tool (N m)
  unsigned char Contact;
  unsigned char Unfinished;
  unsigned char Renewed;
};

/** Largest number of values of the ToolColumns of all tools together in a recording. */
constexpr int MostToolNumbers = 7;

/** A tick of a recording. */
struct RecordingRow
{
  TraceRow Trace;
  double DeviceTip[3];     ///< tip in the device's space (m)
  double Command[3];       ///< force sent to the device (N)
  double TorqueCommand[3]; ///< torque sent to the device (N m)
  /// w, x, y, z of a unit quaternion; all 0 if the device measures none
  double DeviceOrientation[4];
  double Orientation[4];           ///< orientation of the stylus in the world
  double OfTools[MostToolNumbers]; ///< recorded arrays of each kind of tool, one after another
  double Share; ///< fraction of the force that the gate let through (ForceGate.h)
  std::int64_t Tick;
  std::int32_t Placement;
  std::int32_t Buttons;
  unsigned char Enabled;
  unsigned char Armed;
  unsigned char Fault;
  unsigned char Reason; ///< a GateReason, why Share is below 1
  unsigned char Spinning;
  unsigned char RemovalRequest; ///< request about removed tissue that began in the tick
};

/**
 * Integrates the work (J) of force and torque on the hand since the first record, with the
 * trapezoidal rule.
 */
class WorkMeter
{
public:
  double Add(const TickRecord& record)
  {
    // Skip tips that are not finite.
    if (this->HasLast && IsFinite(record.Tip) && IsFinite(this->LastTip))
    {
      this->Work += 0.5 * Dot(record.Force + this->LastForce, record.Tip - this->LastTip);
      this->AddTurn(record);
    }
    this->HasLast = true;
    this->LastTip = record.Tip;
    this->LastForce = record.Force;
    this->LastTorque = record.Torque;
    this->LastOrientation = record.HandOrientation;
    return this->Work;
  }

private:
  /** Adds the work of the torque of a tool with a shape, if it is held at both records. */
  void AddTurn(const TickRecord& record)
  {
    Quaternion from = this->LastOrientation;
    Quaternion to = record.HandOrientation;
    if (!MakeUnit(from) || !MakeUnit(to))
    {
      return;
    }
    const Quaternion turn = to * Conjugate(from);
    const Vector3 axis{ turn.X, turn.Y, turn.Z }; // rotation axis times the sine of half the angle
    const double sine = Norm(axis);
    if (sine > 0.0)
    {
      // Use the shorter rotation, since q and -q are the same orientation.
      const double angle =
        2.0 * std::atan2(turn.W < 0.0 ? -sine : sine, std::abs(turn.W)); // angle about `axis`
      this->Work += 0.5 * (angle / sine) * Dot(record.Torque + this->LastTorque, axis);
    }
  }

  bool HasLast = false;
  Vector3 LastTip;
  Vector3 LastForce;
  Vector3 LastTorque;
  Quaternion LastOrientation = NoOrientation;
  double Work = 0.0;
};

/**
 * Returns the label just inside the surface at a record's proxy, or at the point of an inserted
 * needle; 0 without a label.
 */
std::int64_t GetTraceLabel(const HapticModel& model, const TickRecord& record);

/** Returns whether the wall in front of a forbidden label holds the proxy of a record. */
bool IsHeldAtForbidden(const HapticModel& model, const TickRecord& record);

/**
 * Calls a visitor with each number of a row and the record's member that it comes from. The visitor
 * should transform points and directions from device space to the world of the model's image.
 */
template <typename Visitor>
void VisitTraceSources(Visitor&& visit)
{
  visit.Point(&TraceRow::Proxy, &TickRecord::Proxy);
  visit.Point(&TraceRow::Tip, &TickRecord::Tip);
  visit.Direction(&TraceRow::Force, &TickRecord::Force);
  visit.Number(&TraceRow::NormalForce, &TickRecord::NormalForce);
  visit.Number(&TraceRow::FrictionForce, &TickRecord::FrictionForce);
  visit.Number(&TraceRow::DragForce, &TickRecord::DragForce);
  visit.Direction(&TraceRow::Normal, &TickRecord::Normal);
  visit.Direction(&TraceRow::Torque, &TickRecord::Torque);
  visit.Number(&TraceRow::GradientMagnitude, &TickRecord::GradientMagnitude);
  visit.Number(&TraceRow::SurfaceValue, &TickRecord::SurfaceValue);
  visit.Number(&TraceRow::MediumValue, &TickRecord::MediumValue);
  visit.Number(&TraceRow::Stiffness, &TickRecord::Stiffness);
  visit.Number(&TraceRow::Friction, &TickRecord::Friction);
  visit.Number(&TraceRow::Viscosity, &TickRecord::Viscosity);
  visit.Number(&TraceRow::SurfaceStrength, &TickRecord::SurfaceStrength);
  visit.Byte(&TraceRow::Contact, &TickRecord::Contact);
  visit.Byte(&TraceRow::Unfinished, &TickRecord::IsUnfinished);
  visit.Byte(&TraceRow::Renewed, &TickRecord::IsRenewed);
}

/** Returns the data time of a row; 0 if the volume does not move. */
double GetTraceDataTime(const HapticModel& model, const TickRecord& record);

/** Returns the volume's value V at the proxy of a record. */
double GetTraceValue(const HapticModel& model, const TickRecord& record);

/** Fill a row from a record, transformed from device space to the world of the model's image. */
void FillTraceRow(
  const HapticModel& model, double time, const TickRecord& record, WorkMeter& work, TraceRow& row);
RecordingRow MakeRecordingRow(
  const HapticModel& model, const ServoSnapshot& snapshot, int placement, WorkMeter& work);

} // namespace VolumeHaptics

#endif
