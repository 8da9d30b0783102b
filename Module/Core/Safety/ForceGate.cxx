// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/ForceGate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{

void ForceGate::Settle() noexcept
{
  if (this->IsOpen())
  {
    this->State = this->Ending != End::None ? GateState::Fading
      : this->Held                          ? GateState::Holding
      : this->Retreats                      ? GateState::Retreating
      : this->Unconfirmed                   ? GateState::Confirming
      : this->Ramp < 1.0                    ? GateState::Ramping
                                            : GateState::Armed;
  }
}

void ForceGate::Shut(GateReason why) noexcept
{
  this->State = GateState::Disarmed;
  this->Cause = IsFault(this->Cause) ? this->Cause : why;
}

bool ForceGate::Arm(bool isSole) noexcept
{
  if (this->Clutched)
  {
    this->Ending = End::None;
    this->Returns = true;
    if (this->State == GateState::Disarmed)
    {
      this->Shut(GateReason::Clutched);
    }
    return false;
  }
  const bool isFelt = isSole && this->Flows && this->Ending == End::None;
  this->Ending = End::None;
  if (!isFelt)
  {
    // The hand has moved while it felt nothing, and a spring from the old proxy would push it.
    this->Restarts = true;
    this->Cause = GateReason::None;
    this->State = GateState::Ramping;
    this->Ramp = 0.0;
    this->Retreats = this->Retreated = false;
  }
  this->Settle();
  return !isFelt;
}

void ForceGate::Disarm() noexcept
{
  this->Ending = End::None;
  this->Returns = false;
  this->Shut(GateReason::Ordered);
}

void ForceGate::FadeOut() noexcept
{
  this->Ending = this->Ending == End::None ? End::Disarmed : this->Ending;
  this->Returns = false;
  if (this->Cause == GateReason::Clutched)
  {
    this->Shut(GateReason::Ordered);
  }
  this->Settle();
}

void ForceGate::SetHeld(bool held) noexcept
{
  // A fade that has begun continues to zero. The force may begin again only after that.
  const bool isHeld = held || (this->Held && !this->Rests);
  if (this->Held && !isHeld)
  {
    // The hand has moved while it felt nothing, and a spring from the old proxy would push it back.
    this->Restarts = true;
    this->Ramp = 0.0;
  }
  this->Held = isHeld;
  this->Settle();
}

void ForceGate::SetUnconfirmed(bool unconfirmed) noexcept
{
  if (this->Unconfirmed && !unconfirmed)
  {
    // The hand has moved while it did not feel the volume.
    this->Restarts = true;
    this->Ramp = 0.0;
  }
  this->Unconfirmed = unconfirmed;
  this->Settle();
}

bool ForceGate::SetClutched(bool clutched) noexcept
{
  const bool begins = clutched && !this->Clutched;
  const bool returns = !clutched && this->Returns;
  this->Clutched = clutched;
  if (begins && this->IsOpen())
  {
    const bool wasFadingOut = this->Ending == End::Disarmed;
    this->Disarm();
    this->Returns = !wasFadingOut;
    this->Cause = wasFadingOut ? GateReason::Ordered : GateReason::Clutched;
  }
  if (returns)
  {
    this->Returns = false;
    this->Arm(false);
  }
  return returns;
}

void ForceGate::ReportSilence() noexcept
{
  if (this->IsOpen() && !this->Held)
  {
    // If the owner returns during the fade, the fade continues, so that the user notices the fault
    // before the force returns.
    this->EndInFault(GateReason::Unattended);
  }
}

void ForceGate::ReportUnstable() noexcept
{
  if (this->IsOpen())
  {
    this->EndInFault(GateReason::Active);
  }
}

void ForceGate::EndInFault(GateReason fault) noexcept
{
  this->EndFault = this->Ending == End::Fault ? this->EndFault : fault;
  this->Ending = End::Fault;
  this->Settle();
}

void ForceGate::ReportNotReady() noexcept
{
  this->Returns = false;
  this->Shut(GateReason::NotReady);
}

void ForceGate::ReportData(double residency, double period) noexcept
{
  const double step = period / FadeTime;
  const double wanted = this->IsClosing() ? 0.0 : residency;
  const double change = wanted - this->Opening;
  // Don't use std::clamp, so that a target within one step is reached exactly, to the bit.
  this->Opening = std::fabs(change) <= step ? wanted : this->Opening + std::copysign(step, change);
  this->Data = residency;
}

void ForceGate::ReportFault(GateReason fault) noexcept
{
  // A clutch is only an interruption, but the stylus may have moved while the device was lost.
  const bool isOver = this->Returns && fault == GateReason::DeviceLost;
  if (this->IsOpen() || isOver)
  {
    this->State = GateState::Fault;
    this->Cause = fault;
    this->Returns = false;
  }
}

void ForceGate::ReportGap(bool isStale, bool flows) noexcept
{
  if (this->IsOpen())
  {
    this->Ramp = 0.0;
    this->Retreats = isStale || flows;
    this->Settle();
  }
}

void ForceGate::ReportJump() noexcept
{
  if (this->IsOpen())
  {
    this->Ramp = 0.0;
    this->Settle();
  }
}

double ForceGate::Pass(double step) noexcept
{
  if (this->Unconfirmed)
  {
    this->Share = this->Ramp = 0.0;
    return this->Opening;
  }
  this->Share = this->Opening * this->Ramp;
  this->Ramp = std::min(1.0, this->Ramp + step);
  return this->Share;
}

void ForceGate::ReportRetreat(bool isStale, bool flows) noexcept
{
  this->Share = 0.0;
  this->Retreats = isStale || flows;
}

void ForceGate::Cut() noexcept
{
  this->Share = 0.0;
  this->Ramp = 0.0;
  this->Retreats = false;
}

void ForceGate::EndFade() noexcept
{
  this->Ending == End::Fault ? this->ReportFault(this->EndFault) : this->Shut(GateReason::Ordered);
  this->Ending = End::None;
}

void ForceGate::ReportCommand(bool flows) noexcept
{
  this->Flows = flows;
  // The slew limit may keep the command above zero after the gate has closed, so a fade ends only
  // when the command is zero, too.
  if (!flows && this->Ending != End::None && this->Opening == 0.0)
  {
    this->EndFade();
  }
  // The hand has moved while it was not observed, so restart the proxy at the tip. Don't do this
  // while a force flows, because the force would jump.
  this->Restarts = this->Restarts || (!flows && (this->Retreated || this->Retreats));
  this->Retreated = this->Retreats;
  this->Rests = this->Held && !flows;
  // The device may be armed during a hold. The force must then begin at zero, not with the
  // remaining opening of a fade.
  this->Opening = this->Rests ? 0.0 : this->Opening;
  this->Settle();
}

GateReason ForceGate::GetReason() const noexcept
{
  switch (this->State)
  {
    case GateState::Fading:
      return this->Ending == End::Fault ? this->EndFault : GateReason::Ordered;
    case GateState::Holding:
      return GateReason::LongWork;
    case GateState::Retreating:
      return GateReason::NoSamples;
    case GateState::Confirming:
      return GateReason::Confirming;
    case GateState::Ramping:
    case GateState::Armed:
      if (this->Data < 1.0)
      {
        return GateReason::NoData;
      }
      return this->Ramp < 1.0 || this->Share < 1.0 ? GateReason::Rising : GateReason::None;
    default:
      return this->Cause;
  }
}

bool ForceGate::DrainRestart() noexcept
{
  return std::exchange(this->Restarts, false);
}

} // namespace VolumeHaptics
