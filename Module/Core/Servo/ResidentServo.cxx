// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/ResidentServo.h"

#include "Core/Model/HapticModel.h"
#include "Core/Regions/Residency.h"
#include "Core/Safety/ForceGate.h"
#include "Core/Servo/ServoTick.h"

namespace VolumeHaptics
{

void ResidentServo::Rest(double period, ForceGate& gate) noexcept
{
  this->IsOut = false;
  this->Lacks = false;
  this->Awaits = false;
  gate.ReportData(1.0, period);
}

void ResidentServo::Tick(const HapticModel& model, ServoState& state, const Vector3& tip,
  double period, TickRecord& record, const LocalSurfaceResult& result, ForceGate& gate,
  ToolMemory* tool) noexcept
{
  const double there = model.Resident.IsWhole() ? 1.0 : ComputeResidency(model, state, tip);
  if (!(there > 0.0) && !this->IsOut)
  {
    this->IsOut = true;
    const bool isFelt = state.Enabled && gate.GetOpening() > 0.0;
    this->Force = isFelt ? record.Force : Vector3{};
    this->Lag = isFelt ? record.Proxy - record.Tip : Vector3{};
  }
  this->Lacks = this->IsOut;
  gate.ReportData(this->IsOut ? 0.0 : there, period);
  const double opening = gate.GetOpening();
  // While the opening rises again after a fade or a hold, the gate is not waiting for data.
  const bool isLess = opening < 1.0 && !gate.IsClosing() && (this->Awaits || there < 1.0);
  this->Awaits = !model.Resident.IsWhole() && (this->IsOut || isLess);
  if (!this->IsOut)
  {
    TickAndServe(model, state, tip, record, result, &this->Taps, tool);
    return;
  }
  if (opening == 0.0 || !state.Enabled)
  {
    // A disabled state begins at the tip, without a force.
    this->Force = this->Lag = Vector3{};
    record = TickRecord{};
  }
  record.Tip = tip;
  record.DataTime = state.DataTime;
  record.Proxy = tip + this->Lag;
  record.Force = this->Force;
  record.IsRenewed = record.IsUnfinished = record.IsServed = false;
  record.Request = RemovalRequest::None;
  record.RemovedVolume = 0.0;
  state.Proxy = state.PreviousTip = tip;
  state.Precise = PreciseState{};
  state.Precise.ReachedTip = tip;
  state.LetGo();
  state.Enabled = opening > 0.0;
  this->IsOut = opening > 0.0;
}

} // namespace VolumeHaptics
