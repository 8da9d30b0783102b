// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/ResidentServo.h"

#include "Core/Model/HapticModel.h"
#include "Core/Regions/Residency.h"
#include "Core/Servo/ServoTick.h"

namespace VolumeHaptics
{

void ResidentServo::Follow(double target, double period) noexcept
{
  const double step = period / FadeTime;
  const double wanted = this->FadesOut || this->Held ? 0.0 : target;
  // Not std::clamp: what is within a step is reached to the bit.
  const double way = wanted - this->Share;
  this->Share = std::fabs(way) <= step ? wanted : this->Share + std::copysign(step, way);
}

void ResidentServo::Rest(double period) noexcept
{
  this->IsOut = false;
  this->Awaits = false;
  this->Follow(1.0, period);
}

void ResidentServo::Tick(const HapticModel& model, ServoState& state, const Vector3& tip,
  double period, TickRecord& record, const LocalSurfaceResult& result) noexcept
{
  const double there = model.Resident.IsWhole() ? 1.0 : FindResidency(model, state, tip);
  if (!(there > 0.0) && !this->IsOut)
  {
    this->IsOut = true;
    const bool isFelt = state.Enabled && this->Share > 0.0;
    this->Force = isFelt ? record.Force : Vector3{};
    this->Lag = isFelt ? record.Proxy - record.Tip : Vector3{};
  }
  this->Follow(this->IsOut ? 0.0 : there, period);
  this->Awaits = !model.Resident.IsWhole() &&
    (this->IsOut || (this->Share < 1.0 && !this->FadesOut && !this->Held));
  if (!this->IsOut)
  {
    VolumeHaptics::Tick(model, state, tip, record, result);
    return;
  }
  if (this->Share == 0.0 || !state.Enabled)
  {
    // Whoever disabled the state wants to begin from the tip, without force.
    this->Force = this->Lag = Vector3{};
    record = TickRecord{};
  }
  record.Tip = tip;
  record.Proxy = tip + this->Lag;
  record.Force = this->Force;
  record.IsRenewed = record.IsUnfinished = false;
  state.Proxy = state.PreviousTip = tip;
  state.Precise = PreciseState{};
  state.Precise.ReachedTip = tip;
  state.Enabled = this->Share > 0.0;
  this->IsOut = this->Share > 0.0;
}

} // namespace VolumeHaptics
